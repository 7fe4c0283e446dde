// Any bytes as a .gltf or .glb file: it must load into a scene that holds its invariants or end in gnomon::Error.
#include <span>

#include "base/error.h"
#include "base/log.h"
#include "scene/load.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  gnomon::set_log_level(gnomon::LogLevel::error);
  try {
    gnomon::check_scene(gnomon::load_gltf_from_memory(std::as_bytes(std::span(data, size)), "fuzz.glb", {}));
  } catch (const gnomon::Error&) {
  }
  return 0;
}
