# gnomon_embed(target function FILE...): the files, one after another, as `std::string_view gnomon::<function>()` in `target`.
# Bytes in an array, not a string literal: compilers promise only 64 KB of the latter. The same file is the script that
# the build runs, so that an edited page is embedded again without configuring.
# gnomon_embed_files(target function FILE...): the files apart, by their names without extension:
# `std::span<const std::pair<std::string_view, std::string_view>> gnomon::<function>()`, name and content.
if(CMAKE_SCRIPT_MODE_FILE AND APART)
  set(arrays "")
  set(entries "")
  set(index 0)
  foreach(input IN LISTS INPUTS)
    file(READ ${input} content HEX)
    get_filename_component(name ${input} NAME_WE)
    string(REGEX REPLACE "................................................................" "\\0\n" hex "${content}")
    string(REGEX REPLACE "[0-9a-f][0-9a-f]" "0x\\0," bytes "${hex}")
    string(APPEND arrays "const unsigned char file_${index}[] = {\n${bytes}};\n")
    string(APPEND entries "    {\"${name}\", {reinterpret_cast<const char*>(file_${index}), sizeof file_${index}}},\n")
    math(EXPR index "${index} + 1")
  endforeach()
  file(WRITE ${OUTPUT} "// Made by cmake/gnomon_embed.cmake.
#include <span>
#include <string_view>
#include <utility>

namespace gnomon {
namespace {
${arrays}}  // namespace
std::span<const std::pair<std::string_view, std::string_view>> ${FUNCTION}();

std::span<const std::pair<std::string_view, std::string_view>> ${FUNCTION}() {
  static const std::pair<std::string_view, std::string_view> files[] = {
${entries}  };
  return files;
}
}  // namespace gnomon
")
  return()
endif()
if(CMAKE_SCRIPT_MODE_FILE)
  set(hex "")
  foreach(input IN LISTS INPUTS)
    file(READ ${input} content HEX)
    string(APPEND hex ${content} "0a")
  endforeach()
  string(REGEX REPLACE "................................................................" "\\0\n" hex "${hex}")
  string(REGEX REPLACE "[0-9a-f][0-9a-f]" "0x\\0," bytes "${hex}")
  file(WRITE ${OUTPUT} "// Made by cmake/gnomon_embed.cmake.
#include <string_view>

namespace gnomon {
std::string_view ${FUNCTION}();

std::string_view ${FUNCTION}() {
  static const unsigned char bytes[] = {
${bytes}};
  return {reinterpret_cast<const char*>(bytes), sizeof bytes};
}
}  // namespace gnomon
")
  return()
endif()

set(GNOMON_EMBED_SCRIPT ${CMAKE_CURRENT_LIST_FILE})

# gnomon_embed_with(APART? target function FILE...): what the two below share.
function(gnomon_embed_with apart target function)
  set(inputs "")
  foreach(file IN LISTS ARGN)
    cmake_path(ABSOLUTE_PATH file BASE_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR})
    list(APPEND inputs ${file})
  endforeach()
  set(output ${CMAKE_CURRENT_BINARY_DIR}/embedded/${function}.cpp)
  add_custom_command(OUTPUT ${output}
    COMMAND ${CMAKE_COMMAND} "-DOUTPUT=${output}" "-DFUNCTION=${function}" "-DINPUTS=${inputs}" -DAPART=${apart} -P ${GNOMON_EMBED_SCRIPT}
    DEPENDS ${inputs} ${GNOMON_EMBED_SCRIPT} COMMENT "Embedding ${function}" VERBATIM)
  target_sources(${target} PRIVATE ${output})
endfunction()

function(gnomon_embed target function)
  gnomon_embed_with(OFF ${target} ${function} ${ARGN})
endfunction()

function(gnomon_embed_files target function)
  gnomon_embed_with(ON ${target} ${function} ${ARGN})
endfunction()
