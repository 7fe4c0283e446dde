# Techniques are folders: src/shadow/map/projection/<id>, src/shadow/map/filter/<id>, src/shadow/direct/<id>. This file finds
# them, writes the registry, and writes one resolve kernel per pair of projection and filter. Nothing else lists techniques.

# Sets <out> to the ids of the folders below `folder`.
function(gnomon_technique_ids folder out)
  file(GLOB tables CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/src/shadow/${folder}/*/*.params)
  set(ids "")
  foreach(table IN LISTS tables)
    get_filename_component(id ${table} NAME_WE)
    get_filename_component(parent ${table} DIRECTORY)
    get_filename_component(parent ${parent} NAME)
    if(NOT id STREQUAL parent)
      message(FATAL_ERROR "src/shadow/${folder}/${parent}: the table must be named ${parent}.params, as its folder (found ${id}.params)")
    endif()
    if(NOT id MATCHES "^[a-z][a-z0-9_]*$")
      message(FATAL_ERROR "src/shadow/${folder}/${id}: an id is made of a-z, 0-9 and _")
    endif()
    list(APPEND ids ${id})
    # The sources of a folder know their own id and table, so that a copied folder needs no edit.
    file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/src/shadow/${folder}/${id}/*.cpp)
    set_property(SOURCE ${sources} DIRECTORY ${CMAKE_SOURCE_DIR}/src/shadow APPEND PROPERTY COMPILE_DEFINITIONS
      GNOMON_ID=${id} GNOMON_TECHNIQUE_PARAMS="shadow/${folder}/${id}/${id}.params")
  endforeach()
  set(${out} ${ids} PARENT_SCOPE)
endfunction()

# Writes the kernel <kind>/<name>.comp from src/shadow/map/kernels/<kind>.comp.in, and adds it to the caller's `generated`.
function(gnomon_generated_kernel kind name PROJECTION FILTER)
  set(kernel ${CMAKE_BINARY_DIR}/kernels/${kind}/${name}.comp)
  configure_file(${CMAKE_SOURCE_DIR}/src/shadow/map/kernels/${kind}.comp.in ${kernel} @ONLY)
  set(generated ${generated} ${kind}/${name}.comp ${kernel} PARENT_SCOPE)
endfunction()

# Sets GNOMON_GENERATED_SHADERS (name file ...) and writes registry.cpp; called in src/shadow.
function(gnomon_find_techniques registry)
  gnomon_technique_ids(map/projection projections)
  gnomon_technique_ids(map/filter filters)
  gnomon_technique_ids(direct directs)

  set(generated "")
  foreach(projection IN LISTS projections)
    foreach(filter IN LISTS filters)
      gnomon_generated_kernel(resolve ${projection}/${filter} "${projection}" "${filter}")
    endforeach()
  endforeach()
  # What explains a pair: one kernel for each projection, and one for each filter that says how far it reaches.
  foreach(projection IN LISTS projections)
    gnomon_generated_kernel(explain ${projection} "${projection}" "")
  endforeach()
  foreach(filter IN LISTS filters)
    gnomon_generated_kernel(radius ${filter} "" "${filter}")
  endforeach()
  # Filters that store something else than depth bring <id>_encode.glsl and <id>_history.glsl: the kernels that make what they store
  # and blend it with the last frame's.
  foreach(filter IN LISTS filters)
    foreach(step encode:convert history:history)
      string(REPLACE ":" ";" step ${step})
      list(GET step 0 part)
      list(GET step 1 kind)
      if(EXISTS ${CMAKE_SOURCE_DIR}/src/shadow/map/filter/${filter}/${filter}_${part}.glsl)
        gnomon_generated_kernel(${kind} ${filter} "" "${filter}")
      endif()
    endforeach()
  endforeach()
  set(GNOMON_GENERATED_SHADERS ${generated} PARENT_SCOPE)

  set(declarations "")
  foreach(kind Projection Filter Direct)
    string(TOLOWER ${kind} lower)
    set(list "")
    foreach(id IN LISTS ${lower}s)
      string(APPEND declarations "${kind}Info ${lower}_info_${id}();\n")
      string(APPEND list "      ${lower}_info_${id}(),\n")
    endforeach()
    string(APPEND functions "std::span<const ${kind}Info> ${lower}s() {\n  static const std::vector<${kind}Info> all = {\n${list}  };\n"
      "  return all;\n}\n")
  endforeach()
  file(CONFIGURE OUTPUT ${registry} CONTENT
"// Made by cmake/gnomon_techniques.cmake from the folders below src/shadow.
#include \"shadow/registry.h\"
namespace gnomon {
${declarations}
${functions}}
" @ONLY)
endfunction()
