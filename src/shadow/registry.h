// The folders that the build found. Each folder defines one info with the macro at the end of this file; the lists are written
// by cmake/gnomon_techniques.cmake.
#pragma once

#include <functional>
#include <memory>
#include <span>

#include "shadow/map/filter.h"
#include "shadow/map/projection.h"
#include "shadow/technique.h"

namespace gnomon {

struct ProjectionInfo {
  std::string id, manual;
  ParamTable params;
  std::vector<LightKind> light_kinds;
  std::unique_ptr<Projection> (*make)(const ParamBlock&);
};

struct FilterInfo {
  std::string id, manual;
  ParamTable params;
  // Why this filter cannot read the maps of a projection; empty: it can.
  std::string (*refuses)(const ProjectionInfo&);
  std::unique_ptr<Filter> (*make)(const ParamBlock&);
};

struct DirectInfo {
  std::string id, manual;
  ParamTable params;
  std::vector<LightKind> light_kinds;
  std::unique_ptr<Technique> (*make)(TechniqueContext&, const ParamBlock&);
};

std::span<const ProjectionInfo> projections();
std::span<const FilterInfo> filters();
std::span<const DirectInfo> directs();

}  // namespace gnomon

#define GNOMON_CONCAT_(a, b) a##b
#define GNOMON_CONCAT(a, b) GNOMON_CONCAT_(a, b)
#define GNOMON_TEXT_(a) #a
#define GNOMON_TEXT(a) GNOMON_TEXT_(a)
#define GNOMON_ID_TEXT GNOMON_TEXT(GNOMON_ID)  // the folder's name, given by the build

// Used once in each technique's .cpp, in namespace gnomon, after its Params were defined:
//   GNOMON_REGISTER(projection, Projection) { return {GNOMON_ID_TEXT, k_manual, param_table_storage(), ...}; }
#define GNOMON_REGISTER(kind, Kind) Kind##Info GNOMON_CONCAT(kind##_info_, GNOMON_ID)()
