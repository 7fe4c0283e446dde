// What files leave out of a mesh, and what makes it fast to draw.
#pragma once

#include "scene/scene.h"

namespace gnomon {

// Area-weighted smooth normals of vertices that share a position index (for parts whose file has none). Faces with a crease
// above `crease_angle` (radians) are split, so that a cube keeps its edges.
void make_normals(MeshPart& part, float crease_angle);

// Tangents from uvs and normals (Lengyel 2001); an arbitrary basis where uvs are degenerate.
void make_tangents(MeshPart& part);

// Merges equal vertices, orders triangles for the vertex cache and vertices for fetch (meshoptimizer). Drops triangles with
// two equal indices or zero area in exact arithmetic of positions, so that raster and rays see the same set.
void optimise(MeshPart& part);

}  // namespace gnomon
