// A filter decides what a texel stores and how it is read back: passes that turn the depth map into what it reads, and in GLSL
// lit() (shadow/map/glsl/visibility.glsl).
#pragma once

#include "base/params.h"
#include "frame/frame.h"
#include "shadow/map/glsl/map_data.glsl"

namespace gnomon {

// The map that a filter belongs to; constant between rebuilds.
struct MapInfo {
  std::string name;   // "projection/filter": of passes and images
  uint32_t size = 0;  // texels along a side
  uint32_t layers = 0;
  float history = 0.0f;  // temporal.history
};

// What the projection drew this frame. Layers that are not in use hold depth 1.
struct DrawnMap {
  const Image& depth;        // D32, an array, with Filter::depth_samples() samples
  const Image* object_ids;   // R32_UINT; null unless Filter::object_ids()
  const Buffer& views;       // ShadowMapData, then a ShadowView for each layer
  uint64_t params;           // device address of the filter's parameters
  const Buffer* last_views;  // of the last frame's map, to blend this one with; null: there is none
};

class Filter {
 public:
  virtual ~Filter() = default;
  virtual void set(const ParamBlock& params) = 0;

  // Constant between rebuilds.
  virtual uint32_t depth_samples() const { return 1; }  // of the depth map; more than one only where record() reads all of them
  virtual bool object_ids() const { return false; }     // the map also stores which object is nearest: MapSample::object_image
  virtual bool item_ids() const { return false; }       // with object_ids: which draw item, so that parts of an object differ

  // Texels from a point's own place that lit() may read, mips aside. Casters farther than this from every point that a layer
  // serves need not be drawn into it.
  virtual float reach() const { return 32.0f; }

  // record() blends what the filter stores with what it stored last (MapInfo::history, DrawnMap::last_views). Otherwise the
  // depth map that it reads is blended already.
  virtual bool blends_history() const { return false; }

  // Called once per build, before record: makes what the filter needs beside the depth map.
  virtual void prepare(Device& /*device*/, const MapInfo& /*info*/) {}
  // Passes between the depth map and the resolve. None where the filter reads depth itself.
  virtual void record(Recorder& /*recorder*/, const DrawnMap& /*map*/) {}
  // What lit() reads.
  virtual const Image& map(const DrawnMap& drawn) const { return drawn.depth; }
};

}  // namespace gnomon
