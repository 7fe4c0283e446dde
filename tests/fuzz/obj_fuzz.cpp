// Any bytes as an OBJ file; what follows a line "%%mtl" is its material library. It must load into a scene that holds its
// invariants or end in gnomon::Error.
#include <filesystem>
#include <string_view>

#include "base/error.h"
#include "base/file.h"
#include "base/log.h"
#include "base/temporary_folder.h"
#include "scene/load.h"

namespace {

// With a picture and a place for the library: fuzz.mtl, fuzz.png.
struct FuzzFolder : gnomon::TemporaryFolder {
  FuzzFolder() {
    gnomon::Image8 image(4, 4);
    for (size_t i = 0; i < image.rgba.size(); ++i) image.rgba[i] = static_cast<uint8_t>(i * 37);
    gnomon::write_png(path() / "fuzz.png", image);
  }
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  static const FuzzFolder temporary;
  const std::filesystem::path& folder = temporary.path();
  gnomon::set_log_level(gnomon::LogLevel::error);
  std::string_view text(reinterpret_cast<const char*>(data), size), library;
  constexpr std::string_view k_divider = "\n%%mtl\n";
  if (const size_t divider = text.find(k_divider); divider != text.npos) {
    library = text.substr(divider + k_divider.size());
    text = text.substr(0, divider);
    gnomon::write_file(folder / "fuzz.mtl", library);
  }
  try {
    gnomon::check_scene(gnomon::load_obj_from_memory(text, "fuzz.obj", folder));
  } catch (const gnomon::Error&) {
  }
  return 0;
}
