// caustics_shader_texts FOLDER: writes what the OpenGL Device hands to the driver, <shader>.vert and
// <shader>.frag of every registered pass and of the template, for compilers that need no driver
// (tests/architecture/shaders.py): with its choices open, so that nothing is left out, and all 0 and all 1
// (<shader>.0.vert ...); and the vertex stage of points that are drawn as quadrilaterals
// (<shader>.quads.vert).
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>

#include "gl_backend/gl_text.hpp"
#include "passes/registry.hpp"
#include "passes/template/copy.hpp"

namespace caustics {

namespace {

bool write_text(const std::filesystem::path& file, const std::string& text) {
  std::ofstream out(file, std::ios::binary);
  out << text << std::flush;
  if (!out) std::fprintf(stderr, "caustics_shader_texts: cannot write %s\n", file.c_str());
  return bool(out);
}

bool write_stages(const std::filesystem::path& folder, const Shader& shader, const std::string& name,
                  const std::vector<int>& choices) {
  return write_text(folder / (name + ".vert"), gl::gl_text(shader, gl::Stage::Vertex, choices)) &&
         write_text(folder / (name + ".frag"), gl::gl_text(shader, gl::Stage::Fragment, choices));
}

bool write_texts(const std::filesystem::path& folder, const Shader& shader) {
  const std::string name(shader.name);
  const std::size_t choices = choices_of(shader).size();
  return write_stages(folder, shader, name, {}) &&
         (choices == 0 || (write_stages(folder, shader, name + ".0", std::vector<int>(choices, 0)) &&
                           write_stages(folder, shader, name + ".1", std::vector<int>(choices, 1))));
}

bool write_quads(const std::filesystem::path& folder, const Shader& shader) {
  return write_text(folder / (std::string(shader.name) + ".quads.vert"),
                    gl::gl_text(shader, gl::Stage::VertexOfQuads));
}

bool write_all(const std::filesystem::path& folder) {
  return write_texts(folder, *copy_pass().shaders[0].shader) &&
         std::all_of(pass_registry().begin(), pass_registry().end(), [&](const Pass& pass) {
           return std::all_of(pass.shaders.begin(), pass.shaders.end(), [&](const Permutation& permutation) {
             return write_texts(folder, *permutation.shader) &&
                    (pass.topology != Topology::Points || write_quads(folder, *permutation.shader));
           });
         });
}

}  // namespace

}  // namespace caustics

int main(int count, char** words) {
  if (count == 2) return caustics::write_all(words[1]) ? 0 : 1;
  std::fprintf(stderr, "usage: caustics_shader_texts FOLDER\n");
  return 2;
}
