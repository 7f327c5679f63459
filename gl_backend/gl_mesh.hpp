// Vertex and index buffers, and how a shader's attributes lie in them.
#pragma once
#include <map>
#include <string_view>
#include <utility>
#include <vector>

#include "gl_backend/gl_object.hpp"
#include "pipeline/gpu/pass_run.hpp"

namespace caustics::gl {

struct Mesh {
  std::vector<MeshData::Attribute> layout;
  BufferObject vertices;
  BufferObject indices;  // 0: the vertices in order
  std::size_t vertex_count = 0;
  std::size_t index_count = 0;
  int stride = 0;  // bytes from vertex to vertex
  // Vertex arrays by the shader that they feed, and whether they feed it once an instance.
  std::map<std::pair<const Shader*, bool>, VertexArrayObject> arrays;

  std::size_t corner_count() const { return indices.id() ? index_count : vertex_count; }
};

// Throws Error (InternalError) when an index is beyond the vertices.
Mesh make_mesh(const MeshData& data);
// Other contents of the same layout and size, in the same buffers; throws Error (InternalError) otherwise.
void update_mesh(Mesh& mesh, const MeshData& data);
// Feeds attribute i of the interface to location i; the mesh must have them all (validated before).
// `instanced`: each vertex of the mesh feeds an instance.
VertexArrayObject make_vertex_array(const Mesh& mesh, const ShaderInterface& interface, bool instanced);

}  // namespace caustics::gl
