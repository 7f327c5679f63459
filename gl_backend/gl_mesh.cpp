#include "gl_backend/gl_mesh.hpp"

#include <string>

#include "pipeline/gpu/error.hpp"

namespace caustics::gl {

namespace {

template <class T>
BufferObject make_buffer(const std::vector<T>& values) {
  GLuint id = 0;
  glCreateBuffers(1, &id);
  BufferObject buffer(id);
  glNamedBufferStorage(id, static_cast<GLsizeiptr>(values.size() * sizeof(T)), values.data(),
                       GL_DYNAMIC_STORAGE_BIT);
  return buffer;
}

template <class T>
void write_buffer(const BufferObject& buffer, const std::vector<T>& values) {
  if (values.empty()) return;
  glNamedBufferSubData(buffer.id(), 0, static_cast<GLsizeiptr>(values.size() * sizeof(T)), values.data());
}

void check_indices(const MeshData& data) {
  const std::size_t count = data.vertex_count();
  for (const std::uint32_t index : data.indices)
    if (index >= count)
      throw Error(ExitCode::InternalError, "a mesh's index " + std::to_string(index) + " is beyond its " +
                                               std::to_string(count) + " vertices");
}

// Bytes from a vertex's start to its attribute.
GLuint offset_of(const Mesh& mesh, std::string_view name) {
  GLuint floats = 0;
  for (const MeshData::Attribute& attribute : mesh.layout) {
    if (attribute.name == name) break;
    floats += static_cast<GLuint>(attribute.components);
  }
  return floats * static_cast<GLuint>(sizeof(float));
}

}  // namespace

Mesh make_mesh(const MeshData& data) {
  Mesh mesh;
  mesh.layout = data.layout;
  mesh.vertex_count = data.vertex_count();
  mesh.index_count = data.indices.size();
  mesh.stride = data.floats_per_vertex() * static_cast<int>(sizeof(float));
  check_indices(data);
  if (!data.vertices.empty()) mesh.vertices = make_buffer(data.vertices);
  if (!data.indices.empty()) mesh.indices = make_buffer(data.indices);
  return mesh;
}

void update_mesh(Mesh& mesh, const MeshData& data) {
  if (data.floats_per_vertex() * static_cast<int>(sizeof(float)) != mesh.stride ||
      data.vertex_count() != mesh.vertex_count || data.indices.size() != mesh.index_count)
    throw Error(ExitCode::InternalError, "a mesh is updated by one of another layout or size");
  check_indices(data);
  write_buffer(mesh.vertices, data.vertices);
  write_buffer(mesh.indices, data.indices);
}

VertexArrayObject make_vertex_array(const Mesh& mesh, const ShaderInterface& interface, bool instanced) {
  GLuint id = 0;
  glCreateVertexArrays(1, &id);
  VertexArrayObject array(id);
  glVertexArrayVertexBuffer(id, 0, mesh.vertices.id(), 0, mesh.stride);
  if (instanced) glVertexArrayBindingDivisor(id, 0, 1);
  if (mesh.indices.id()) glVertexArrayElementBuffer(id, mesh.indices.id());
  for (std::size_t i = 0; i < interface.attributes.size(); ++i) {
    const auto location = static_cast<GLuint>(i);
    glEnableVertexArrayAttrib(id, location);
    glVertexArrayAttribFormat(id, location, interface.attributes[i].components, GL_FLOAT, GL_FALSE,
                              offset_of(mesh, interface.attributes[i].name));
    glVertexArrayAttribBinding(id, location, 0);
  }
  return array;
}

}  // namespace caustics::gl
