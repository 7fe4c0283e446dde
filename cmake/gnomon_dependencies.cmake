# Every third-party library, from the distribution's packages (scripts/setup.sh). Includes of theirs are SYSTEM: their
# warnings are not ours.
find_package(Threads REQUIRED)
find_package(Vulkan REQUIRED)
find_package(glm REQUIRED)
find_package(fmt REQUIRED)
find_package(spdlog REQUIRED)
find_package(CLI11 REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(OpenEXR REQUIRED)
find_package(meshoptimizer REQUIRED)
find_package(TBB REQUIRED)
find_program(GLSLC glslc REQUIRED)

# Embree 3 (Debian 12) and 4 (Debian 13, Ubuntu 24.04) differ in the name of the package and in a few calls.
find_package(embree 4 QUIET)
if(NOT embree_FOUND)
  find_package(embree 3 REQUIRED)
endif()

# Header-only fmt: the binary then runs on a machine that has another version of the library.
add_library(gnomon_fmt INTERFACE)
target_link_libraries(gnomon_fmt INTERFACE fmt::fmt-header-only)
target_compile_definitions(gnomon_fmt INTERFACE SPDLOG_FMT_EXTERNAL)

find_path(STB_INCLUDE stb_image.h PATH_SUFFIXES stb REQUIRED)
find_path(WEBP_INCLUDE webp/decode.h REQUIRED)
find_library(WEBP_LIBRARY webp REQUIRED)
find_path(VMA_INCLUDE vk_mem_alloc.h REQUIRED)
find_path(TINYGLTF_INCLUDE tiny_gltf.h REQUIRED)
find_path(DRACO_INCLUDE draco/compression/decode.h REQUIRED)
find_library(DRACO_LIBRARY draco REQUIRED)

if(GNOMON_VIEWER)
  find_package(glfw3 3.3 REQUIRED)
  find_path(IMGUI_INCLUDE imgui.h PATH_SUFFIXES imgui REQUIRED)
  find_library(IMGUI_LIBRARY imgui REQUIRED)
  find_library(STB_LIBRARY stb REQUIRED)  # the distribution's Dear ImGui packs its font with it
endif()
