# gnomon_layer(name DEPENDS ...): the static library gnomon_<name> of all sources below the current folder.
# VkStruct x = {sType} leaves the rest zero on purpose.
set(GNOMON_WARNINGS -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion -Wno-missing-field-initializers -Werror)

add_library(gnomon_options INTERFACE)
target_include_directories(gnomon_options INTERFACE ${CMAKE_SOURCE_DIR}/src)
# No fused multiply-add: generated scenes are the same bits on every machine and with every compiler.
target_compile_options(gnomon_options INTERFACE ${GNOMON_WARNINGS} -ffp-contract=off)
# GCC 12 at -O3 sees overlapping copies in std::string's own code (its bug 105651).
target_compile_options(gnomon_options INTERFACE $<$<CONFIG:Release>:-Wno-restrict>)
if(GNOMON_SANITIZE)
  target_compile_options(gnomon_options INTERFACE -fsanitize=${GNOMON_SANITIZE} -fno-omit-frame-pointer)
  target_link_options(gnomon_options INTERFACE -fsanitize=${GNOMON_SANITIZE})
endif()
if(GNOMON_PORTABLE)
  target_link_options(gnomon_options INTERFACE -static-libstdc++ -static-libgcc)
endif()

function(gnomon_layer name)
  cmake_parse_arguments(layer "" "" "DEPENDS" ${ARGN})
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS *.cpp)
  add_library(gnomon_${name} STATIC ${sources})
  target_link_libraries(gnomon_${name} PUBLIC gnomon_options ${layer_DEPENDS})
endfunction()
