// Turns points and a light into rays, traces them in packets of eight, and counts.
#include "reference/cpu/embree_reference.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <thread>

#include "base/error.h"
#include "base/interrupt.h"
#include "base/log.h"
#include "reference/cpu/acceleration.h"
#include "reference/cpu/confidence.h"
#include "scene/light_shape.h"
#include "scene/ray_extents.h"

namespace gnomon {
namespace {

// Points of one task: enough to hide the scheduling, few enough to balance two to a hundred cores.
constexpr size_t k_block = 1024;
constexpr int k_packet = 8;

struct Job {
  std::span<const SurfacePoint> points;
  vec3 eye_ws;
  LightShape light;
  vec2 extents;
  uint32_t samples, seed;
};

// Rays wait here until eight are together; the samples of one point, and of neighbours, point the same way, which is what a
// packet is fast at. Counts the rays that arrive.
class RayPacket {
 public:
  RayPacket(RTCScene scene, std::span<uint32_t> arrived) : scene_(scene), arrived_(arrived) {}

  void add(size_t point, const vec3& origin, const LightRay& ray) {
    const int i = count_++;
    owner_[i] = point;
    rays_.org_x[i] = origin.x, rays_.org_y[i] = origin.y, rays_.org_z[i] = origin.z;
    rays_.dir_x[i] = ray.direction.x, rays_.dir_y[i] = ray.direction.y, rays_.dir_z[i] = ray.direction.z;
    rays_.tnear[i] = 0.0f, rays_.tfar[i] = ray.distance;
    rays_.time[i] = 0.0f, rays_.mask[i] = ~0u, rays_.id[i] = 0, rays_.flags[i] = 0;
    if (count_ == k_packet) flush();
  }

  void flush() {
    alignas(32) int valid[k_packet];
    for (int i = 0; i < k_packet; ++i) valid[i] = i < count_ ? -1 : 0;
    embree::occluded_8(scene_, valid, &rays_);
    for (int i = 0; i < count_; ++i) arrived_[owner_[i]] += rays_.tfar[i] >= 0.0f ? 1 : 0;
    count_ = 0;
  }

 private:
  RTCScene scene_;
  std::span<uint32_t> arrived_;
  size_t owner_[k_packet] = {};
  RTCRay8 rays_ = {};
  int count_ = 0;
};

// The samples of one point that lie above its horizon; returns how many those are.
uint32_t add_rays(const Job& job, size_t index, const SurfacePoint& point, RayPacket& packet) {
  const float eye_distance = glm::distance(point.position_ws, job.eye_ws);
  const vec3 origin = ray_origin(point.position_ws, point.geometric_normal_ws, eye_distance, job.extents);
  uint32_t counted = 0;
  for (uint32_t i = 0; i < job.samples; ++i) {
    const LightRay ray = light_ray(job.light, origin, light_sample(i, point.pixel, job.seed));
    if (!above_horizon(ray, point.geometric_normal_ws)) continue;
    packet.add(index, origin, ray);
    ++counted;
  }
  if (counted > 0) return counted;
  LightShape centre = job.light;
  centre.emitter_radius = 0.0f;
  packet.add(index, origin, light_ray(centre, origin, vec2(0.5f)));
  return 1;
}

void check_point(const SurfacePoint& point) {
  const vec3 sum = point.position_ws + point.geometric_normal_ws;
  if (!std::isfinite(sum.x + sum.y + sum.z))
    fail("the surface point of pixel {} is not a finite position and normal", point.pixel);
}

// Fills the entries [begin, end) of the result and the squared standard error of each.
void trace_block(const Job& job, RTCScene scene, size_t begin, size_t end, ReferenceResult& result,
                 std::vector<float>& variance) {
  uint32_t arrived[k_block] = {}, counted[k_block] = {};
  RayPacket packet(scene, arrived);
  for (size_t i = begin; i < end; ++i) {
    const SurfacePoint& point = job.points[i];
    if (point.object == k_no_object) continue;
    check_point(point);
    if (!receives_light(job.light, point.position_ws, point.geometric_normal_ws)) continue;
    result.receiver[i] = 1;
    counted[i - begin] = add_rays(job, i - begin, point, packet);
  }
  packet.flush();
  for (size_t i = begin; i < end; ++i) {
    const uint32_t n = counted[i - begin];
    if (n == 0) continue;
    const float p = static_cast<float>(arrived[i - begin]) / static_cast<float>(n);
    result.visibility[i] = p;
    if (job.light.emitter_radius > 0.0f) variance[i] = visibility_variance(p, static_cast<int>(n));
  }
}

}  // namespace

struct EmbreeReference::Implementation {
  explicit Implementation(const Scene& scene) : acceleration(scene), extents(ray_extents(scene)) {}
  Acceleration acceleration;
  vec2 extents;
};

EmbreeReference::EmbreeReference(const Scene& scene) : implementation_(std::make_unique<Implementation>(scene)) {}
EmbreeReference::~EmbreeReference() = default;

size_t EmbreeReference::triangle_count() const { return implementation_->acceleration.triangle_count(); }

ReferenceResult EmbreeReference::trace(std::span<const SurfacePoint> points, const vec3& eye_ws, const Light& light, bool area,
                                       int samples, uint32_t seed) const {
  if (samples < 1) fail("the reference needs at least one sample, not {}", samples);
  Job job{points, eye_ws, light_shape(light, area), implementation_->extents, static_cast<uint32_t>(samples), seed};
  if (job.light.emitter_radius == 0.0f) job.samples = 1;

  ReferenceResult result;
  result.visibility.resize(points.size());
  result.receiver.resize(points.size());
  std::vector<float> variance(points.size());
  Progress progress("reference", points.size());
  std::atomic<size_t> done = 0;
  const auto caller = std::this_thread::get_id();
  const size_t blocks = (points.size() + k_block - 1) / k_block;
  // One block a task, always the same blocks: no sum depends on the number of threads.
  tbb::parallel_for(size_t{0}, blocks, [&](size_t block) {
    if (interrupted()) return;
    const size_t begin = block * k_block, end = std::min(begin + k_block, points.size());
    trace_block(job, implementation_->acceleration.top(), begin, end, result, variance);
    done += end - begin;
    if (std::this_thread::get_id() == caller) progress.update(done);
  });
  check_interrupted();
  result.confidence = mean_confidence(points, variance, result.receiver);
  return result;
}

}  // namespace gnomon
