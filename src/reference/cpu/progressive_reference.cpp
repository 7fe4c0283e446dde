// A thread that traces bands of points, and looks between two bands whether it is still wanted.
#include "reference/cpu/progressive_reference.h"

#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>

#include "base/error.h"

namespace gnomon {
namespace {

// A band is given up within some 50 ms on two cores.
constexpr size_t k_rays_of_band = 65536;

// One core is left to whoever shows the answers.
int thread_count() { return std::max(1, static_cast<int>(std::thread::hardware_concurrency()) - 1); }

// Sample counts of the answers: 1, 4, 16, ... and the wanted one.
std::vector<int> sample_counts(int samples) {
  std::vector<int> counts;
  for (int n = 1; n < samples; n *= 4) counts.push_back(n);
  counts.push_back(samples);
  return counts;
}

bool has_area(const ProgressiveReference::View& view, const Light& light) { return view.area && light.has_size(); }

}  // namespace

ProgressiveReference::ProgressiveReference(SharedReference& rays, size_t caster_triangles)
    : rays_of_scene_(rays),
      caster_triangles_(caster_triangles),
      thread_([this](const std::stop_token& token) { work(token); }) {}

ProgressiveReference::~ProgressiveReference() { stop(); }

void ProgressiveReference::start(View view) {
  const std::lock_guard lock(mutex_);
  next_ = std::move(view);
  answer_.reset();
  ++generation_;
  changed_.notify_all();
}

void ProgressiveReference::stop() {
  const std::lock_guard lock(mutex_);
  next_.reset();
  answer_.reset();
  ++generation_;
}

std::optional<ProgressiveReference::Answer> ProgressiveReference::poll() {
  const std::lock_guard lock(mutex_);
  if (!error_.empty()) fail("the reference: {}", std::exchange(error_, {}));
  return std::exchange(answer_, std::nullopt);
}

double ProgressiveReference::share() const {
  const std::lock_guard lock(mutex_);
  return rays_done_ / rays_;
}

bool ProgressiveReference::wanted(uint64_t generation) const {
  const std::lock_guard lock(mutex_);
  return generation == generation_;
}

void ProgressiveReference::work(const std::stop_token& stop) {
  while (true) {
    View view;
    uint64_t generation = 0;
    {
      std::unique_lock lock(mutex_);
      if (!changed_.wait(lock, stop, [&] { return next_.has_value(); })) return;
      view = std::move(*next_);
      next_.reset();
      generation = generation_;
    }
    try {
      tbb::task_arena(thread_count()).execute([&] { trace(view, generation); });
    } catch (const std::exception& error) {
      const std::lock_guard lock(mutex_);
      if (generation == generation_) error_ = error.what();
    }
  }
}

void ProgressiveReference::trace(const View& view, uint64_t generation) {
  const EmbreeReference& rays = rays_of_scene_.get();
  if (const size_t held = rays.triangle_count(); held != caster_triangles_) {
    fail("the structure holds {} triangles, but {} are drawn as casters: it is not to be believed", held, caster_triangles_);
  }
  const bool any_area =
      std::any_of(view.lights.begin(), view.lights.end(), [&](const Light& light) { return has_area(view, light); });
  const std::vector<int> counts = sample_counts(any_area ? view.samples : 1);
  {
    const std::lock_guard lock(mutex_);
    rays_ = rays_done_ = 0.0;
    for (const Light& light : view.lights) {
      for (const int n : counts)
        rays_ += static_cast<double>(view.points.size()) * (has_area(view, light) ? n : n == 1 ? 1 : 0);
    }
    rays_ = std::max(rays_, 1.0);
  }
  Answer answer;
  answer.lights.resize(view.lights.size());
  for (const int samples : counts) {
    for (size_t light = 0; light < view.lights.size(); ++light) {
      if (samples > 1 && !has_area(view, view.lights[light])) continue;
      if (!trace_light(rays, view, generation, light, samples, answer.lights[light])) return;
    }
    answer.samples = samples;
    answer.complete = samples == counts.back();
    const std::lock_guard lock(mutex_);
    if (generation != generation_) return;
    answer_ = answer;
  }
}

bool ProgressiveReference::trace_light(const EmbreeReference& rays, const View& view, uint64_t generation, size_t light,
                                       int samples, ReferenceResult& result) {
  ReferenceResult whole;
  double square_sum = 0.0;
  size_t receivers = 0;
  const size_t pixel = view.samples_of_pixel;
  const size_t band = std::max<size_t>(k_rays_of_band / static_cast<size_t>(samples) / pixel, 1) * pixel;
  for (size_t begin = 0; begin < view.points.size(); begin += band) {
    if (!wanted(generation)) return false;
    const auto points = std::span(view.points).subspan(begin, std::min(band, view.points.size() - begin));
    const ReferenceResult part =
        rays.trace(points, view.eye_ws, view.lights[light], has_area(view, view.lights[light]), samples, view.seed);
    whole.visibility.insert(whole.visibility.end(), part.visibility.begin(), part.visibility.end());
    whole.receiver.insert(whole.receiver.end(), part.receiver.begin(), part.receiver.end());
    // Errors of bands are independent: those of their sums add up as squares.
    const auto count = static_cast<size_t>(std::count(part.receiver.begin(), part.receiver.end(), 1));
    square_sum += std::pow(part.confidence * static_cast<double>(count), 2.0);
    receivers += count;
    const std::lock_guard lock(mutex_);
    rays_done_ += static_cast<double>(points.size()) * samples;
  }
  if (receivers > 0) whole.confidence = std::sqrt(square_sum) / static_cast<double>(receivers);
  result = std::move(whole);
  return true;
}

}  // namespace gnomon
