// One maker for each built-in scene; the table of names and options is in builtin.cpp.
#pragma once

#include <map>
#include <string>

#include "scene/scene.h"

namespace gnomon {

using BuiltinOptions = std::map<std::string, double>;  // every option present and in range

Scene make_courtyard(const BuiltinOptions& options);
Scene make_hexworld(const BuiltinOptions& options);
Scene make_lamps(const BuiltinOptions& options);
Scene make_landscape(const BuiltinOptions& options);
Scene make_terrain(const BuiltinOptions& options);
Scene make_town(const BuiltinOptions& options);
Scene make_chart_sphere(const BuiltinOptions& options);
Scene make_chart_slab(const BuiltinOptions& options);
Scene make_chart_fence(const BuiltinOptions& options);

}  // namespace gnomon
