// Finding and decoding the pictures of materials.
#include "scene/obj/obj_pictures.h"

#include <array>

#include "base/error.h"
#include "base/file.h"
#include "base/interrupt.h"
#include "base/log.h"
#include "scene/parallel.h"

namespace gnomon {

namespace fs = std::filesystem;

void ObjPictures::add(const std::string& name, const fs::path& library_folder, PictureUse use, const std::string& material) {
  if (name.empty()) return;
  const auto [named, is_new] = named_.try_emplace({name, library_folder}, nullptr);
  if (is_new) {
    const std::array folders = {library_folder, folder_};
    auto path = finder_.find(name, folders);
    // In a name # is a letter; where no file has that name, it begins a comment.
    if (const size_t comment = name.find(" #"); !path && comment != name.npos)
      path = finder_.find(name.substr(0, comment), folders);
    if (path) named->second = &(pictures_[*path]);
  }
  if (named->second) named->second->materials.push_back(material);
  // Of two uses the colour's says what is lost.
  PictureUse& worst = named->second ? named->second->use : missing_.try_emplace(name, use).first->second;
  if (use == PictureUse::colour) worst = use;
}

void ObjPictures::load() {
  for (const PictureUse use : {PictureUse::colour, PictureUse::normals}) {
    std::vector<std::string> names;
    for (const auto& [name, lost] : missing_) {
      if (lost == use) names.push_back(name);
    }
    const std::string_view what = use == PictureUse::colour ? "missing textures" : "missing bump and normal maps";
    if (!names.empty()) log_warning("{}: {}: {}; {}", source_, what, first_names(names), consequence_without(use));
  }
  std::vector<Picture*> work;
  for (auto& [path, picture] : pictures_) {
    picture.path = path;
    work.push_back(&picture);
  }
  Progress progress("reading textures", work.size());
  parallel_for(work.size(), progress, [&](size_t i) {
    Picture& picture = *work[i];
    try {
      picture.encoded = read_file(picture.path);
      picture.image = decode_image(picture.encoded, picture.path.string());
    } catch (const Interrupted&) {
      throw;
    } catch (const Error& error) {
      picture.problem = error.what();
    }
  });
  for (const Picture* picture : work) {
    if (picture->problem.empty()) continue;
    log_warning("{}: a picture of {}: {}; {}", source_, first_names(picture->materials), picture->problem,
                consequence_without(picture->use));
  }
}

const ObjPictures::Picture* ObjPictures::find(const std::string& name, const fs::path& library_folder) const {
  const auto found = named_.find({name, library_folder});
  return found == named_.end() || !found->second || !found->second->problem.empty() ? nullptr : found->second;
}

ImageF heights_of(const ObjPictures::Picture& picture) { return decode_height_map(picture.encoded, picture.path.string()); }

}  // namespace gnomon
