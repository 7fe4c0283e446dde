# Compiles every shader below src/ and every generated kernel to SPIR-V, and links the words into the library gnomon_shaders
# (gpu/shader.h finds them by name). A shader's name is its path below src/: "frame/shading/shade.comp".
enable_language(ASM)
set(GNOMON_SHADER_STAGES comp vert frag geom rgen rmiss rahit rchit)
# Also those of the viewer, which compiles shaders that change while it runs (src/lab/live_shaders/shader_compiler.cpp).
set(GNOMON_GLSLC_FLAGS --target-env=vulkan1.3 -Werror -O)

# gnomon_compile_shader(NAME FILE): appends to GNOMON_SPIRV and GNOMON_SHADER_NAMES of the caller. Paths are relative to the build
# folder, where the command runs: glslc does not escape blanks in the list of includes that it writes.
function(gnomon_compile_shader name file)
  set(spirv ${CMAKE_BINARY_DIR}/shaders/${name}.spv)
  get_filename_component(folder ${spirv} DIRECTORY)
  file(MAKE_DIRECTORY ${folder})
  file(RELATIVE_PATH source ${CMAKE_BINARY_DIR} ${file})
  file(RELATIVE_PATH includes ${CMAKE_BINARY_DIR} ${CMAKE_SOURCE_DIR}/src)
  add_custom_command(OUTPUT ${spirv}
    COMMAND ${GLSLC} ${GNOMON_GLSLC_FLAGS} -I ${includes} -MD -MF shaders/${name}.spv.d -o shaders/${name}.spv ${source}
    DEPENDS ${file} DEPFILE ${spirv}.d WORKING_DIRECTORY ${CMAKE_BINARY_DIR} COMMENT "glslc ${name}" VERBATIM)
  set(GNOMON_SPIRV ${GNOMON_SPIRV} ${spirv} PARENT_SCOPE)
  set(GNOMON_SHADER_NAMES ${GNOMON_SHADER_NAMES} ${name} PARENT_SCOPE)
endfunction()

# gnomon_add_shader_library(GENERATED name file name file ...)
function(gnomon_add_shader_library)
  list(TRANSFORM GNOMON_SHADER_STAGES PREPEND ${CMAKE_SOURCE_DIR}/src/*. OUTPUT_VARIABLE patterns)
  file(GLOB_RECURSE files CONFIGURE_DEPENDS ${patterns})
  foreach(file IN LISTS files)
    file(RELATIVE_PATH name ${CMAKE_SOURCE_DIR}/src ${file})
    gnomon_compile_shader(${name} ${file})
  endforeach()
  while(ARGN)
    list(POP_FRONT ARGN name file)
    gnomon_compile_shader(${name} ${file})
  endwhile()

  set(assembly ".section .rodata\n")
  set(declarations "")
  set(entries "")
  set(index 0)
  foreach(name spirv IN ZIP_LISTS GNOMON_SHADER_NAMES GNOMON_SPIRV)
    set(symbol gnomon_shader_${index})
    string(APPEND assembly ".balign 4\n.global ${symbol}, ${symbol}_end\n${symbol}:\n.incbin \"${spirv}\"\n${symbol}_end:\n")
    string(APPEND declarations "extern \"C\" const uint32_t ${symbol}[], ${symbol}_end[];\n")
    string(APPEND entries "    {\"${name}\", {${symbol}, ${symbol}_end}},\n")
    math(EXPR index "${index} + 1")
  endforeach()
  string(APPEND assembly ".section .note.GNU-stack,\"\",%progbits\n")
  file(CONFIGURE OUTPUT ${CMAKE_BINARY_DIR}/shaders/spirv.S CONTENT "${assembly}" @ONLY)
  file(CONFIGURE OUTPUT ${CMAKE_BINARY_DIR}/shaders/shader_table.cpp CONTENT
"// Made by cmake/gnomon_shaders.cmake.
#include \"gpu/shader.h\"
#include <map>
#include <string>
#include \"base/error.h\"
${declarations}
namespace gnomon {
std::span<const uint32_t> built_in_shader(std::string_view name) {
  static const std::map<std::string_view, std::span<const uint32_t>> table = {
${entries}  };
  const auto found = table.find(name);
  if (found == table.end()) fail(\"shader '{}' is not part of this build\", name);
  return found->second;
}
}
" @ONLY)
  set_source_files_properties(${CMAKE_BINARY_DIR}/shaders/spirv.S PROPERTIES OBJECT_DEPENDS "${GNOMON_SPIRV}")
  add_library(gnomon_shaders STATIC ${CMAKE_BINARY_DIR}/shaders/spirv.S ${CMAKE_BINARY_DIR}/shaders/shader_table.cpp)
  target_link_libraries(gnomon_shaders PRIVATE gnomon_base)
endfunction()
