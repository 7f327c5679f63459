// What the triangles of one object form together: degenerate and doubled triangles, closedness,
// orientation. Works on the shapes of one object that share a material, since exporters split solid
// glass into several primitives.
#pragma once
#include <vector>

#include "pipeline/scene/gltf/context.hpp"
#include "pipeline/scene/gltf/shape.hpp"

namespace caustics::gltf {

// Drops triangles without area; returns how many.
std::size_t drop_degenerate(Shape& shape);

// Welds equal positions over all shapes of the group, drops triangles given twice, and writes to
// each shape how closed the group is: 1 less the area of its holes over the area of its surface. Where
// `solid` (the material transmits light) and the group is closed, triangles are turned to face outwards:
// those that disagree with their neighbours, and all of them where the signed volume is negative. Other
// meshes keep the winding of the file, and are told if they are inside out, as rooms are.
void join_group(Context& context, const std::vector<Shape*>& group, bool solid);

}  // namespace caustics::gltf
