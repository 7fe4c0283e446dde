// What the user has made in a scene, to be found again on coming back.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "app/viewer/camera/saved_cameras.h"
#include "lab/view/path_file.h"

namespace gnomon::viewer {

struct SceneWork {
  SavedCameras cameras;
  std::vector<Recording> paths;  // recorded or loaded
};

// Built-in names or paths; two paths of one file are one scene.
bool same_scene(const std::string& a, const std::string& b);

class SceneWorks {
 public:
  // The scene's; it stays where it is while others are added.
  SceneWork& of(const std::string& scene);

 private:
  std::map<std::string, SceneWork> works_;
};

}  // namespace gnomon::viewer
