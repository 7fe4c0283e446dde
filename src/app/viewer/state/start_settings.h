// Where the panels began, and what their "reset" goes back to.
#pragma once

#include "app/viewer/state/view_state.h"

namespace gnomon::viewer {

// As command line, presets and scene say, without what the panels changed since.
Settings start_settings(const ViewState& state, const Scene& scene);

}  // namespace gnomon::viewer
