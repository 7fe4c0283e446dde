// Draws casters into the layers of a shadow map: culling in compute, then one of four ways to reach the layers.
#pragma once

#include "frame/casters/caster_list.h"
#include "frame/gpu_scene.h"
#include "gpu/pipeline.h"
#include "gpu/recorder.h"

namespace gnomon {

// How draws reach their layers (Nguyen Hoang et al. 2014 compare the first with the third).
enum class LayeringPath : uint32_t {
  per_layer,     // a rendering scope for each layer
  vertex_layer,  // one scope; each draw names its layer, which the vertex shader selects
  geometry,      // one scope; a geometry shader copies triangles into the layers that their draw touches
  multiview,     // one scope; the device repeats each draw in every layer
};
std::string_view layering_path_name(LayeringPath path);
// Empty, or the feature that the device lacks.
std::string layering_path_missing(const DeviceInfo& device, LayeringPath path);

enum class CasterCulling : uint32_t { none, objects, clusters };

// The views of a map's layers, on the GPU: each begins with a LightView.
struct LightViews {
  const Buffer* buffer = nullptr;
  size_t offset = 0;  // bytes to the first
  uint32_t stride = 0, layers = 0;
  bool clip_near = false;  // what lies before a near plane is left out in spite of CasterDrawOptions::depth_clamp
  uint64_t address() const { return buffer->address() + offset; }
};

struct CasterDrawOptions {
  LayeringPath path = LayeringPath::per_layer;
  bool depth_clamp = false;  // what lies before a near plane is drawn onto it
  uint32_t layers = 1;
  uint32_t samples = 1;  // of the depth map
  bool paraboloid =
      false;  // every view is one: triangles are intersected texel by texel instead of bent at their vertices (path: geometry)
  bool object_ids = false;  // also writes the item's object + 1 into a colour attachment, R32_UINT
  bool item_ids = false;    // with object_ids: the draw item + 1 instead, so that parts of an object differ
};

class CasterDraws {
 public:
  // Throws Error (device) where the device lacks what the path needs.
  CasterDraws(Device& device, const GpuScene& scene, const std::string& name, const CasterDrawOptions& options);

  // Adds the passes "<prefix>/cull" and "<prefix>/depth" (one for each layer where the path is per_layer). `ids`: null without
  // object_ids. `front_face_culling` draws only faces that are turned away from the light.
  void record(Recorder& recorder, const std::string& prefix, const LightViews& views, CasterCulling culling,
              bool front_face_culling, const Image& map, const Image* ids = nullptr);

 private:
  void record_cull(Recorder& recorder, const std::string& prefix, const LightViews& views, CasterCulling culling);
  void record_layers(Recorder& recorder, const std::string& name, const LightViews& views, const CasterList& list,
                     bool front_face_culling, const Image& map, const Image* ids, uint32_t first_layer, uint32_t layer_count);

  Device* device_;
  const GpuScene* scene_;
  CasterDrawOptions options_;
  Buffer draws_, counts_, chunk_counts_;
  struct DrawPipelines {
    Pipeline opaque, masked;
  };
  DrawPipelines make_pipelines(bool depth_clamp) const;

  Pipeline count_, write_;
  DrawPipelines clipped_, clamped_;  // clamped_: only with depth_clamp
};

}  // namespace gnomon
