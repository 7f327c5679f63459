#include "pipeline/gpu/validate.hpp"

#include <algorithm>
#include <set>

#include "pipeline/gpu/device.hpp"
#include "pipeline/gpu/error.hpp"

namespace caustics {

namespace {

[[noreturn]] void refuse(const PassDefinition& definition, const std::string& why) {
  throw Error(ExitCode::InternalError, "pass '" + definition.name + "': " + why);
}

// Every name that a definition lists must be the one that its shader declares in the same place.
template <class Listed>
void require_same_names(const PassDefinition& definition, const Listed& listed,
                        const std::vector<std::string>& declared, const std::string& what,
                        const std::string& keyword) {
  const std::string shader = " its shader '" + std::string(definition.shader->name) + "' declares ";
  const auto [found, wanted] =
      std::mismatch(listed.begin(), listed.end(), declared.begin(), declared.end(),
                    [](const auto& here, const std::string& there) { return here.name == there; });
  if (found != listed.end() && wanted != declared.end())
    refuse(definition, what + " " + std::to_string(found - listed.begin()) + " is '" + found->name + "'," +
                           shader + "'" + *wanted + "' there; name and order them alike");
  if (listed.size() != declared.size())
    refuse(definition, "lists " + std::to_string(listed.size()) + " " + what + "s," + shader +
                           std::to_string(declared.size()) + "; make the definition and the shader's " +
                           keyword + " lines agree");
}

// Fragments of zeros may be left out only where nobody can tell.
void require_left_out_to_be_unseen(const PassDefinition& definition, const ShaderInterface& interface) {
  const auto adds = [](const ColorWrite& write) { return write.blend == kAccumulate; };
  const bool seen = definition.topology != Topology::Rectangles || definition.depth ||
                    definition.count_samples ||
                    !std::all_of(definition.writes.begin(), definition.writes.end(), adds);
  if (seen) refuse(definition, "leaves out zeros that are not added; unset `zero_outside_quad`");
  if (*definition.zero_outside_quad < 0 || *definition.zero_outside_quad + 8 > interface.varying_components())
    refuse(definition, "has no eight varying components from `zero_outside_quad` on");
}

void require_distinct_names(const PassDefinition& definition) {
  std::set<std::string> seen;
  for (const ColorWrite& write : definition.writes)
    if (!seen.insert(write.name).second)
      refuse(definition, "writes '" + write.name + "' twice; give each attachment its own name");
  for (const TextureRead& read : definition.reads)
    if (!read.of_material && seen.count(read.name))
      refuse(definition, "reads and writes '" + read.name + "'; use two textures");
}

}  // namespace

void validate(const PassDefinition& definition) {
  if (definition.name.empty()) throw Error(ExitCode::InternalError, "a pass has no name");
  if (!definition.shader) refuse(definition, "has no shader; set `shader`");
  require_distinct_names(definition);
  const ShaderInterface& interface = interface_of(*definition.shader);
  require_same_names(definition, definition.reads, interface.textures, "read", "TEXTURE");
  require_same_names(definition, definition.writes, interface.outputs, "write", "OUTPUT");
  for (const TextureRead& read : definition.reads)
    if (!read.only_towards.empty() && !read.optional)
      refuse(definition, "needs '" + read.name + "' for '" + read.only_towards + "' alone; mark it optional");
  if (definition.writes.empty() && !definition.depth) refuse(definition, "writes nothing; add an attachment");
  if (definition.writes.size() > 8)
    refuse(definition, "writes " + std::to_string(definition.writes.size()) +
                           " colour attachments; 8 are the most that OpenGL promises");
  if (definition.reads.size() > 16)
    refuse(definition, "reads more than the 16 textures that OpenGL promises");
  for (const ColorWrite& write : definition.writes)
    if (is_depth(write.format))
      refuse(definition, "attachment '" + write.name + "' has a depth format; use `depth`");
  const bool uses_depth = definition.depth_state.compare != Compare::Always || definition.depth_state.write;
  if (uses_depth && !definition.depth)
    refuse(definition, "tests or writes depth without a depth attachment; add `depth`");
  if (definition.zero_outside_quad) require_left_out_to_be_unseen(definition, interface);
}

void validate(const PassRun& run, const Device& device) {
  if (!run.definition) throw Error(ExitCode::InternalError, "a run names no pass definition");
  const PassDefinition& definition = *run.definition;
  if (run.colors.size() != definition.writes.size())
    refuse(definition, "got " + std::to_string(run.colors.size()) + " colour targets, writes " +
                           std::to_string(definition.writes.size()));
  if (definition.depth.has_value() != (run.depth != TextureId::None))
    refuse(definition, definition.depth ? "needs a depth target" : "takes no depth target");
  if (!run.keep.empty() && run.keep.size() != run.colors.size() + (definition.depth ? 1 : 0))
    refuse(definition, "`keep` must have one entry for each attachment, or none");

  ImageShape size{};
  const auto check_target = [&](TextureId texture, Format format, const std::string& name) {
    const ImageShape shape = device.shape(texture);
    if (shape.format != format)
      refuse(definition, "target '" + name + "' has format " + std::string(format_name(shape.format)) +
                             ", must be " + std::string(format_name(format)));
    if (size.width == 0) size = shape;
    if (size.width != shape.width || size.height != shape.height)
      refuse(definition, "target '" + name + "' differs in size from the first target");
  };
  for (std::size_t i = 0; i < run.colors.size(); ++i)
    if (run.colors[i] != TextureId::None)
      check_target(run.colors[i], definition.writes[i].format, definition.writes[i].name);
  if (definition.depth) check_target(run.depth, Format::Depth32F, definition.depth->name);
  if (size.width == 0) refuse(definition, "is drawn into nothing; give it a target");
  if (run.counts_into != OcclusionQuery::None && !definition.count_samples)
    refuse(definition, "counts no samples for its occlusion query; set `count_samples`");

  const ShaderInterface& interface = interface_of(*definition.shader);
  for (const Draw& draw : run.draws) {
    if (draw.textures.size() != definition.reads.size())
      refuse(definition, "a draw binds " + std::to_string(draw.textures.size()) +
                             " textures, the pass reads " + std::to_string(definition.reads.size()));
    for (const TextureId texture : draw.textures)
      if (texture != TextureId::None &&
          (texture == run.depth ||
           std::find(run.colors.begin(), run.colors.end(), texture) != run.colors.end()))
        refuse(definition, "a draw reads a texture that the pass writes; use two textures");
    if (draw.uniforms.size() % 16 != 0) refuse(definition, "a uniform block must be a multiple of 16 bytes");
    if (definition.shader->uniform_bytes && draw.uniforms.size() != definition.shader->uniform_bytes())
      refuse(definition, "a draw has " + std::to_string(draw.uniforms.size()) +
                             " bytes of uniforms, its shader '" + std::string(definition.shader->name) +
                             "' declares " + std::to_string(definition.shader->uniform_bytes()) +
                             "; fill the struct of its own text");
    if (draw.mesh != MeshId::None && definition.topology == Topology::Rectangles)
      refuse(definition, "draws rectangles of a mesh; draw them by number");
    if (draw.mesh == MeshId::None && !interface.attributes.empty())
      refuse(definition, "its shader has vertex attributes, but a draw has no mesh");
    for (const ShaderVariable& attribute : interface.attributes) {
      const MeshData::Attribute* found = device.find_attribute(draw.mesh, attribute.name);
      if (!found || found->components != attribute.components)
        refuse(definition, "the mesh lacks attribute '" + attribute.name + "' with " +
                               std::to_string(attribute.components) + " components");
    }
  }
}

}  // namespace caustics
