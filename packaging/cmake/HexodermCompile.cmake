# One place for language level, warnings and sanitizers: hexoderm_compile_options(target).

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)

if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Build type" FORCE)
endif()

find_program(HEXODERM_CCACHE ccache)
if(HEXODERM_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  # Precompiled headers carry time stamps; without this ccache never hits.
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env
      CCACHE_SLOPPINESS=pch_defines,time_macros ${HEXODERM_CCACHE})
endif()

# A debug build is for the step from a changed line to its test: debug information stays beside the objects, and the
# library is a list of these.
if(CMAKE_BUILD_TYPE STREQUAL "Debug" AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  add_compile_options(-gsplit-dwarf)
  foreach(action CREATE APPEND)
    set(CMAKE_CXX_ARCHIVE_${action} "<CMAKE_AR> qcT <TARGET> <LINK_FLAGS> <OBJECTS>")
  endforeach()
endif()

if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # g++ looks for memory to reuse from 512 MB on, instead of 128, and compiles faster.
  add_compile_options($<$<COMPILE_LANGUAGE:CXX>:--param=ggc-min-heapsize=524288>)
endif()

# errno after a square root is never looked at.
add_compile_options(-fno-math-errno)

if(HEXODERM_SANITIZE)
  add_compile_options(-fsanitize=${HEXODERM_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  add_link_options(-fsanitize=${HEXODERM_SANITIZE})
  if(HEXODERM_SANITIZE MATCHES "address" AND HEXODERM_SANITIZE MATCHES "undefined")
    # The address sanitizer ends at a null pointer, and beyond an object, by itself; asking at every access takes a quarter
    # of the time to compile.
    add_compile_options(-fno-sanitize=null,object-size)
  endif()
  if(CMAKE_CXX_COMPILER_ID MATCHES "Clang")
    if(HEXODERM_SANITIZE MATCHES "undefined")
      # A block of an empty matrix begins beside a null pointer, in Eigen too; nobody reads there.
      add_compile_options(-fno-sanitize=pointer-overflow)
    endif()
    # As g++ does by itself.
    if(HEXODERM_SANITIZE MATCHES "address")
      add_compile_definitions(__SANITIZE_ADDRESS__)
    elseif(HEXODERM_SANITIZE MATCHES "thread")
      add_compile_definitions(__SANITIZE_THREAD__)
    endif()
  endif()
  if(HEXODERM_SANITIZE MATCHES "thread")
    # The thread sanitizer knows no fences. Asio's queues are guarded by mutexes, which it knows.
    add_compile_definitions(BOOST_ASIO_DISABLE_FENCED_BLOCK)
  endif()
endif()

if(HEXODERM_FUZZ)
  if(NOT CMAKE_CXX_COMPILER_ID MATCHES "Clang")
    message(FATAL_ERROR "HEXODERM_FUZZ needs clang: cmake --preset fuzz")
  endif()
  # Coverage for libFuzzer to follow; and an index out of range is a crash.
  add_compile_options(-fsanitize=fuzzer-no-link)
  add_compile_definitions(_GLIBCXX_ASSERTIONS)
endif()

function(hexoderm_compile_options target)
  target_compile_options(${target} PRIVATE
    -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion -Wnon-virtual-dtor
    -Wold-style-cast -Woverloaded-virtual -Wnull-dereference -Wdouble-promotion -Wformat=2)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    # Inlined library code trips these in g++ 12: Eigen and std::map the first, "text" + std::string (GCC bug 105651) the
    # second, Eigen and std::optional the third.
    # With precompiled headers or batches also the fourth: copies of short strings. In g++ 14 std::vector the last.
    target_compile_options(${target} PRIVATE -Wno-null-dereference -Wno-restrict -Wno-maybe-uninitialized
      -Wno-stringop-overflow -Wno-stringop-overread -Wno-array-bounds -Wno-free-nonheap-object)
  endif()
  if(HEXODERM_WERROR)
    target_compile_options(${target} PRIVATE -Werror)
  endif()
endfunction()

# Compiles a target's sources in batches (HEXODERM_UNITY) and with these headers precompiled (HEXODERM_PCH). Sources include
# what they use all the same: the preset tidy compiles each by itself.
function(hexoderm_compile_quickly target)
  if(HEXODERM_UNITY)
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE ${HEXODERM_UNITY_SIZE})
    if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
      # A class of a source file with a member of that file's anonymous namespace: g++ takes the source for a header.
      target_compile_options(${target} PRIVATE -Wno-subobject-linkage)
    endif()
  endif()
  if(HEXODERM_PCH AND ARGN)
    target_precompile_headers(${target} PRIVATE ${ARGN})
  endif()
endfunction()
