// What the user has made and chosen, and keeps when another scene takes the place of the shown one. The command line says how
// it begins.
#pragma once

#include "app/viewer/compare/sides.h"
#include "app/viewer/explain/explain.h"
#include "app/viewer/measure/outputs.h"
#include "app/viewer/notice.h"
#include "app/viewer/panels/panels.h"
#include "app/viewer/shader_reload.h"
#include "app/viewer/state/recent_files.h"
#include "app/viewer/state/scene_work.h"

namespace gnomon::viewer {

struct Workspace {
  explicit Workspace(Device& device) : outputs(device) {}

  Wishes wishes;
  SidesChoice sides;
  ExplainOptions explain;
  Outputs outputs;
  Notices notices;
  SceneWorks scenes;
  RecentFiles recent;
  ShaderReload shaders;  // what changed is what differs from the text at the program's start
  uint32_t frames = 0;   // shown, of all scenes
};

}  // namespace gnomon::viewer
