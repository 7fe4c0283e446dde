// The pictures that materials of an OBJ file name.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "base/image.h"
#include "scene/file_finder.h"
#include "scene/lost_pictures.h"

namespace gnomon {

class ObjPictures {
 public:
  // Pictures are named from the folder of the library, else from that of the scene file.
  ObjPictures(std::string source, std::filesystem::path folder, FileFinder& finder)
      : source_(std::move(source)), folder_(std::move(folder)), finder_(finder) {}

  // To be read by load(). An empty name is none. `material`: who names it.
  void add(const std::string& name, const std::filesystem::path& library_folder, PictureUse use, const std::string& material);
  // Each once, and on all cores. What is missing or damaged is a warning, and is not there.
  void load();

  struct Picture {
    std::filesystem::path path;
    std::vector<std::byte> encoded;
    Image8 image;
    PictureUse use = PictureUse::normals;
    std::string problem;
    std::vector<std::string> materials;  // that name it
  };
  // nullptr where there is none that could be read.
  const Picture* find(const std::string& name, const std::filesystem::path& library_folder) const;

 private:
  std::string source_;
  std::filesystem::path folder_;
  FileFinder& finder_;
  std::map<std::filesystem::path, Picture> pictures_;
  std::map<std::pair<std::string, std::filesystem::path>, Picture*> named_;  // name and folder of the library
  std::map<std::string, PictureUse> missing_;
};

// At the file's own precision.
ImageF heights_of(const ObjPictures::Picture& picture);

}  // namespace gnomon
