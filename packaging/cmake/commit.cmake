# Writes a source with the commit that SOURCES are a checkout of, unless it has it already, so that nothing is compiled
# again for the same one. Without git, or where SOURCES lie in a checkout of something else, it is empty. COMMIT, if it is
# not empty, is taken instead: for packages that are built from an archive.
#   cmake -D SOURCES=DIR -D GIT=PROGRAM -D COMMIT=TEXT -D OUTPUT=FILE -P commit.cmake
set(commit "${COMMIT}")
if(NOT commit AND GIT)
  # Others may be at work in the same checkout: nothing there is locked or refreshed.
  set(git "${GIT}" --no-optional-locks -C "${SOURCES}")
  execute_process(COMMAND ${git} rev-parse --show-toplevel OUTPUT_VARIABLE top RESULT_VARIABLE failed
    OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  file(REAL_PATH "${SOURCES}" sources)
  if(NOT failed AND top STREQUAL sources)
    execute_process(COMMAND ${git} rev-parse HEAD OUTPUT_VARIABLE commit RESULT_VARIABLE failed
      OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
    execute_process(COMMAND ${git} status --porcelain --untracked-files=no OUTPUT_VARIABLE changes ERROR_QUIET)
    if(failed)  # a repository without a commit
      set(commit "")
    elseif(changes)
      string(APPEND commit " with changes")
    endif()
  endif()
endif()
string(REGEX REPLACE "[^A-Za-z0-9._~+ -]" "" commit "${commit}")  # it becomes a literal of C++

set(source "namespace hexoderm::cli {
extern const char* const kCommit;
const char* const kCommit = \"${commit}\";
}  // namespace hexoderm::cli
")
set(old "")
if(EXISTS "${OUTPUT}")
  file(READ "${OUTPUT}" old)
endif()
if(NOT old STREQUAL source)
  file(WRITE "${OUTPUT}" "${source}")
endif()
