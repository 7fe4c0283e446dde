// Materials as single parts need them: where what a material counts on - texture coordinates - is not there, or where the
// vertices add to it what is the material's own here.
#pragma once

#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "scene/scene.h"

namespace gnomon {

class MaterialVariants {
 public:
  explicit MaterialVariants(Scene& scene) : scene_(scene) {}

  // The material of parts that have no texture coordinates: its plain colour. Remembers, for say(), cut-outs that are lost by
  // that. `part`: its mesh or group, for the message.
  int without_uvs(int material, const std::string& part);
  // The material with its alpha multiplied. `tested`: what is below its cutoff does not exist (glTF MASK).
  int with_alpha(int material, float alpha, bool tested);

  // One warning names the materials whose cut-outs are lost.
  void say(const std::string& source) const;

 private:
  Material& at(int material) { return scene_.materials[static_cast<size_t>(material)]; }
  int add(Material material);

  Scene& scene_;
  std::map<int, int> without_uvs_;
  std::map<std::tuple<int, float>, int> with_alpha_;
  std::vector<std::string> lost_;  // "leaf (in tree)"
};

}  // namespace gnomon
