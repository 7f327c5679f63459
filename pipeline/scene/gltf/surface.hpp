// Normals and tangents of a Shape, and the finished Mesh.
// Source: glTF 2.0 section 3.7.2.1 (missing normals are flat, missing tangents computed from uv).
#pragma once
#include "pipeline/scene/gltf/context.hpp"
#include "pipeline/scene/gltf/shape.hpp"

namespace caustics::gltf {

// Gives every vertex a unit normal on the outer side of its triangles: flat ones where the file has
// none (vertices are split), the geometric one in place of zero and non-finite ones.
void finish_normals(Context& context, Shape& shape);

// Gives every vertex a unit tangent perpendicular to its normal. Those not in the file are averaged
// from the gradients of the texture coordinates (not MikkTSpace: seams may differ slightly).
// `uv_transform` is the normal texture's.
void finish_tangents(Context& context, Shape& shape, const glm::mat3& uv_transform);

// Moves the shape to scene space (world minus origin) and single precision; drops unused vertices.
Mesh finish_mesh(const Shape& shape, const glm::dvec3& origin);

}  // namespace caustics::gltf
