// Runs one pass by itself on small textures, on any device: for tests of passes.
#pragma once
#include <map>
#include <string>
#include <vector>

#include "pipeline/gpu/pass_run.hpp"
#include "pipeline/plan/pass.hpp"

namespace caustics {

class Device;

// What a pass wrote, by attachment name.
struct PassImages {
  std::map<std::string, Image> images;
  PassResult result;
  const Image& operator[](const std::string& name) const { return images.at(name); }
};

struct PassInputs {
  int width = 1, height = 1;  // of the targets
  UniformBytes uniforms{};
  std::vector<Image> textures{};  // in the order of the definition's reads; empty images are unbound
  MeshData mesh{};                // empty: `vertex_count` vertices without attributes
  int vertex_count = 3;
};

// What a frame with this effect makes of a pass.
PassDefinition definition_with(const Pass& pass, Effect Effects::*effect, const DrawnFor& drawn_for = kFrame);

PassImages run_pass(Device& device, const PassDefinition& definition, const PassInputs& inputs);

}  // namespace caustics
