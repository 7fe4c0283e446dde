// What the user has made in a scene, to be found again on coming back.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "app/viewer/saved_cameras.h"
#include "lab/path_file.h"

namespace gnomon::viewer {

struct SceneWork {
  SavedCameras cameras;
  std::vector<Recording> paths;  // recorded or loaded
};

class SceneWorks {
 public:
  // `scene`: a built-in name or a path; two paths of one file are one scene. It stays where it is while others are added.
  SceneWork& of(const std::string& scene);

 private:
  std::map<std::string, SceneWork> works_;
};

}  // namespace gnomon::viewer
