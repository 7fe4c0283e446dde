#include "scene/obj/alpha_decision.h"

#include "base/log.h"
#include "scene/lost_pictures.h"
#include "scene/texture_tools.h"

namespace gnomon {

bool AlphaDecision::cuts(const Image8& picture, const std::string& material, bool is_seen) {
  if (rule_ == scene_file_params::alpha_from_colour_off) return false;
  if (rule_ == scene_file_params::alpha_from_colour_on) return has_transparency(picture);
  const AlphaShares shares = alpha_shares(picture);
  if (shares.holes == 0.0) return false;  // nothing would be cut
  const bool cuts = is_cut_out(shares);
  if (!is_seen) return cuts;
  if (shares.holes == 1.0) {
    none_.push_back(material);
  } else {
    (cuts ? cut_ : whole_).push_back(fmt::format("{} ({:.3g} %)", material, 100.0 * shares.holes));
  }
  return cuts;
}

void AlphaDecision::say(const std::string& source) const {
  if (!cut_.empty()) {
    log_warning(
        "{}: holes taken from the alpha of map_Kd, which is mostly clear or solid: {} of the picture; "
        "scene.alpha_from_colour=off makes them whole",
        source, first_names(cut_));
  }
  if (!whole_.empty()) {
    log_warning(
        "{}: no holes taken from the alpha of map_Kd, which is smooth: {} of the picture would be cut; "
        "scene.alpha_from_colour=on cuts them",
        source, first_names(whole_));
  }
  if (!none_.empty()) {
    log_warning(
        "{}: no holes taken from the alpha of map_Kd, which is below one half all over: nothing would be left of {}; "
        "scene.alpha_from_colour=on cuts them away",
        source, first_names(none_));
  }
}

}  // namespace gnomon
