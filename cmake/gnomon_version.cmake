# Run at each build (cmake -P): writes version.cpp when, and only when, the commit or the state of the tree changed.
execute_process(COMMAND git -C ${SOURCE_DIR} rev-parse --short HEAD OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE
                ERROR_QUIET RESULT_VARIABLE failed)
if(failed)
  set(commit unknown)
else()
  execute_process(COMMAND git -C ${SOURCE_DIR} status --porcelain --untracked-files=no OUTPUT_VARIABLE changes)
  if(changes)
    string(APPEND commit "+")
  endif()
endif()
string(TOLOWER "${BUILD_TYPE}" build)
if(build STREQUAL "relwithdebinfo")
  set(build release)
endif()
file(CONFIGURE OUTPUT ${OUTPUT} CONTENT "#include \"base/version.h\"
namespace gnomon {
const char* version() { return \"${VERSION}\"; }
const char* commit() { return \"${commit}\"; }
const char* build_type() { return \"${build}\"; }
}
")
