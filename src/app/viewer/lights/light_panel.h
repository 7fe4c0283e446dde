// The lights as a list with widgets, and over the picture.
#pragma once

#include "app/viewer/lights/light_gizmo.h"

namespace gnomon::viewer {

class LightPanel {
 public:
  // Changes the state's lights; the session still shows those of before. Throws Error (usage) for a name that is taken.
  void show(ViewState& state, Session& session);
  // Marks and handles; nothing while they are switched off.
  void show_gizmo(ViewState& state, Session& session);
  bool has_mouse() const { return gizmo_on_ && gizmo_.has_mouse(); }

 private:
  void list(ViewState& state, Session& session);
  bool edit(ListedLight& listed, const Session& session);
  bool edit_sun(Light& sun, const Session& session);
  bool edit_lamp(ListedLight& listed, const Session& session);

  LightGizmo gizmo_;
  bool gizmo_on_ = true;
  size_t chosen_ = 0;
  char name_[64] = {};
  size_t named_ = ~size_t{0};  // whose name is being typed
};

}  // namespace gnomon::viewer
