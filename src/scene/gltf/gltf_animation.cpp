// Animations of a glTF file at one moment.
#include "scene/gltf/gltf_animation.h"

#include <algorithm>
#include <cmath>

#include "base/hermite.h"
#include "base/log.h"

namespace gnomon {
namespace {

glm::quat to_quat(const float* xyzw) { return {xyzw[3], xyzw[0], xyzw[1], xyzw[2]}; }

void make_unit(std::vector<float>& rotation) {
  float length = 0.0f;
  for (const float x : rotation) length += x * x;
  length = std::sqrt(length);
  if (!(length > 1e-6f) || !std::isfinite(length)) {
    rotation = {0, 0, 0, 1};
    return;
  }
  for (float& x : rotation) x /= length;
}

std::vector<float> slerped(const float* from, const float* to, float t) {
  const glm::quat q = glm::slerp(glm::normalize(to_quat(from)), glm::normalize(to_quat(to)), t);  // the shorter way round
  return {q.x, q.y, q.z, q.w};
}

class AnimationReader {
 public:
  AnimationReader(const GltfAccessors& accessors, const GltfValue& json)
      : accessors_(accessors), samplers_(json.objects("samplers")) {}

  GltfCurve read_curve(const GltfValue& channel, const std::string& path) const {
    const GltfValue& json = samplers_[static_cast<size_t>(channel.required_index("sampler", samplers_.size(), "samplers"))];
    GltfCurve curve;
    curve.interpolation = read_interpolation(json);
    curve.rotation = path == "rotation";
    curve.times = accessors_.numbers(json.required_index("input", accessors_.count(), "accessors"), 1, json.where("input"));
    for (size_t i = 1; i < curve.times.size(); ++i) {
      if (!(curve.times[i] > curve.times[i - 1]))
        json.fail_in("input", "key {} is at {} s, not after the one before it; valid: rising times", i, curve.times[i]);
    }
    const int components = path == "weights" ? 1 : path == "rotation" ? 4 : 3;
    curve.values =
        accessors_.numbers(json.required_index("output", accessors_.count(), "accessors"), components, json.where("output"));
    const size_t keys = curve.times.size() * (curve.interpolation == GltfCurve::Interpolation::cubic_spline ? 3 : 1);
    curve.width = curve.values.size() / keys;
    const bool fits = curve.values.size() % keys == 0 && curve.width > 0;
    if (!fits || (path != "weights" && curve.width != static_cast<size_t>(components))) {
      json.fail_in("output", "has {} elements; valid: {} for each of {} keys{}",
                   curve.values.size() / static_cast<size_t>(components), keys / curve.times.size(), curve.times.size(),
                   path == "weights" ? " and each morph target" : "");
    }
    return curve;
  }

 private:
  static GltfCurve::Interpolation read_interpolation(const GltfValue& json) {
    const std::string text = json.text("interpolation", "LINEAR");
    if (text == "LINEAR") return GltfCurve::Interpolation::linear;
    if (text == "STEP") return GltfCurve::Interpolation::step;
    if (text == "CUBICSPLINE") return GltfCurve::Interpolation::cubic_spline;
    json.fail_in("interpolation", "is \"{}\"; valid: LINEAR, STEP, CUBICSPLINE", text);
  }

  const GltfAccessors& accessors_;
  std::vector<GltfValue> samplers_;
};

size_t keys_without_direction(const GltfCurve& curve) {
  if (!curve.rotation) return 0;
  const bool cubic = curve.interpolation == GltfCurve::Interpolation::cubic_spline;
  size_t count = 0;
  for (size_t key = 0; key < curve.times.size(); ++key) {
    const size_t at = cubic ? (3 * key + 1) * curve.width : key * curve.width;
    count += !(glm::length(glm::make_vec4(&curve.values[at])) > 1e-6f);
  }
  return count;
}

int choose_animation(const GltfDocument& document, const std::vector<GltfValue>& animations, const std::string& name) {
  const int chosen = name.empty() ? 0 : find_named(animations, name);
  if (chosen < 0) fail_usage("{}: --animation {}: valid: {}", document.name(), name, names_of(animations));
  return chosen;
}

}  // namespace

std::vector<float> GltfCurve::at(double time_s) const {
  const bool cubic = interpolation == Interpolation::cubic_spline;
  const size_t stride = cubic ? 3 * width : width, in_key = cubic ? width : 0;
  const auto value = [&](size_t key) { return values.data() + key * stride + in_key; };
  const auto after = std::upper_bound(times.begin(), times.end(), time_s, [](double t, float key) { return t < double{key}; });
  const size_t key = after == times.begin() ? 0 : static_cast<size_t>(after - times.begin()) - 1;
  std::vector<float> result(value(key), value(key) + width);
  const bool between = after != times.begin() && after != times.end();
  if (between && interpolation != Interpolation::step) {
    const float duration = times[key + 1] - times[key];
    const auto t = static_cast<float>((time_s - double{times[key]}) / (double{times[key + 1]} - double{times[key]}));
    if (cubic) {
      const float *out_tangent = value(key) + width, *in_tangent = value(key + 1) - width;
      for (size_t c = 0; c < width; ++c)
        result[c] = hermite(value(key)[c], duration * out_tangent[c], value(key + 1)[c], duration * in_tangent[c], t);
    } else if (rotation) {
      result = slerped(value(key), value(key + 1), t);
    } else {
      for (size_t c = 0; c < width; ++c) result[c] += t * (value(key + 1)[c] - result[c]);
    }
  }
  if (rotation) make_unit(result);
  return result;
}

MorphWeights apply_animation(const GltfDocument& document, const GltfAccessors& accessors, const std::string& animation,
                             double time_s, GltfHierarchy& hierarchy) {
  MorphWeights weights;
  const auto animations = document.root().objects("animations");
  if (animations.empty()) {
    if (!animation.empty()) fail_usage("{}: --animation {}: the file has no animations", document.name(), animation);
    if (time_s != 0.0) fail_usage("{}: --time {}: the file has no animations", document.name(), float(time_s));
    return weights;
  }
  const int chosen = choose_animation(document, animations, animation);
  const GltfValue& json = animations[static_cast<size_t>(chosen)];
  if (animation.empty()) {
    log_info("{}: stands as at {} s of its animation {}, one of {}; --animation and --time choose", document.name(),
             float(time_s), named(json, chosen), animations.size());
  }
  const AnimationReader reader(accessors, json);
  size_t left_out = 0;
  for (const GltfValue& channel : json.objects("channels")) {
    const GltfValue target = channel.required_object("target");
    const int node = target.index("node", hierarchy.size(), "nodes");
    const std::string path = target.text("path", "");
    const bool is_transform = path == "translation" || path == "rotation" || path == "scale";
    if (node < 0 || (!is_transform && path != "weights") || (is_transform && hierarchy.transform(node).matrix)) {
      ++left_out;  // KHR_animation_pointer moves other things; a matrix has no parts that could move
      continue;
    }
    const GltfCurve curve = reader.read_curve(channel, path);
    if (const size_t without = keys_without_direction(curve); without > 0)
      log_warning("{}: {}: {} rotations have no length, which turns nothing; valid: unit quaternions", document.name(),
                  channel.place(), without);
    const std::vector<float> value = curve.at(time_s);
    GltfTransform& transform = hierarchy.transform(node);
    if (path == "translation") transform.translation = glm::make_vec3(value.data());
    if (path == "rotation") transform.rotation = glm::make_vec4(value.data());
    if (path == "scale") transform.scale = glm::make_vec3(value.data());
    if (path == "weights") weights[node] = value;
  }
  if (left_out > 0) {
    log_warning(
        "{}: {}: {} channels move nothing here; read are translation, rotation, scale (of nodes without matrix) and weights",
        document.name(), json.place(), left_out);
  }
  return weights;
}

}  // namespace gnomon
