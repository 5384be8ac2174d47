# The first script that `cmake --install` runs. It installs nothing: it ends an installation of which a part is not built,
# before the first file is copied.
include("${CMAKE_CURRENT_LIST_DIR}/built.cmake")  # which target is of which component
foreach(component Runtime Library Python)
  if(CMAKE_INSTALL_COMPONENT AND NOT CMAKE_INSTALL_COMPONENT STREQUAL component)
    continue()
  endif()
  foreach(target IN LISTS built_${component})
    if(NOT EXISTS "${built_${target}}")
      message(FATAL_ERROR "Nothing is installed, because ${target} is not built. Build all that is installed by\n"
        "  cmake --build ${CMAKE_CURRENT_LIST_DIR} --target hexoderm_installed")
    endif()
  endforeach()
endforeach()
