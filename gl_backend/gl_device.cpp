#include "gl_backend/gl_device.hpp"

#include <algorithm>
#include <map>
#include <tuple>

#include "gl_backend/egl_context.hpp"
#include "gl_backend/gl_backlog.hpp"
#include "gl_backend/gl_debug.hpp"
#include "gl_backend/gl_framebuffer.hpp"
#include "gl_backend/gl_mesh.hpp"
#include "gl_backend/gl_meter.hpp"
#include "gl_backend/gl_occlusion.hpp"
#include "gl_backend/gl_program.hpp"
#include "gl_backend/gl_state.hpp"
#include "gl_backend/gl_texture.hpp"
#include "gl_backend/gl_uniforms.hpp"
#include "pipeline/gpu/error.hpp"
#include "pipeline/gpu/point_rule.hpp"
#include "pipeline/gpu/validate.hpp"

namespace caustics {

namespace gl {

namespace {

std::string text_of(GLenum what) {
  const GLubyte* text = glGetString(what);
  return text ? reinterpret_cast<const char*>(text) : "";
}

bool is_software(const std::string& renderer) {
  for (const char* name : {"llvmpipe", "softpipe", "swrast", "SwiftShader"})
    if (renderer.find(name) != std::string::npos) return true;
  return false;
}

// Why a driver that offers OpenGL 4.5 cannot be used all the same; empty: it can.
std::string unusable(const std::string& renderer) {
  const auto has = [&](const char* part) { return renderer.find(part) != std::string::npos; };
  if (renderer.rfind("softpipe", 0) == 0)
    return "softpipe has OpenGL 3.3 and, made to claim more, draws some passes wrong; unset GALLIUM_DRIVER, "
           "or set it to llvmpipe";
  if (has("llvmpipe") && has("512 bits"))
    return "llvmpipe crashes with vectors of 512 bits; unset LP_NATIVE_VECTOR_WIDTH, or set it to 256";
  return {};
}

GlLimits limits_of_driver(float largest_point) {
  GlLimits limits;
  GLfloat points[2] = {1.0f, 1.0f};
  glGetIntegerv(GL_SUBPIXEL_BITS, &limits.subpixel_bits);
  glGetFloatv(GL_POINT_SIZE_RANGE, points);
  limits.smallest_point = points[0];
  limits.largest_point = largest_point > 0.0f ? std::min(largest_point, points[1]) : points[1];
  return limits;
}

int smallest_limit() {
  GLint limit = 0, viewport[2] = {0, 0}, width = 0, height = 0;
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &limit);
  glGetIntegerv(GL_MAX_VIEWPORT_DIMS, viewport);
  glGetIntegerv(GL_MAX_FRAMEBUFFER_WIDTH, &width);
  glGetIntegerv(GL_MAX_FRAMEBUFFER_HEIGHT, &height);
  return std::min({limit, viewport[0], viewport[1], width, height});
}

VertexArrayObject make_empty_vertex_array() {
  GLuint id = 0;
  glCreateVertexArrays(1, &id);
  return VertexArrayObject(id);
}

class OpenGlDevice final : public GlDevice {
 public:
  OpenGlDevice(const EglCandidate& candidate, const GlOptions& options, std::string passed_over)
      : context_(candidate, options.debug),
        debug_(options.debug),
        platform_(candidate.name),
        renderer_(text_of(GL_RENDERER)),
        version_(text_of(GL_VERSION)),
        passed_over_(std::move(passed_over)),
        limits_(limits_of_driver(options.largest_point)),
        compiling_(options.compiling),
        meter_(options.measure, is_software(renderer_)),
        no_vertices_(make_empty_vertex_array()),
        max_texture_size_(smallest_limit()) {
    if (const std::string why = unusable(renderer_); !why.empty())
      throw Error(ExitCode::BackendUnavailable, why);
    set_common_state();
    zeros_ = make_texture({Format::RGBA32F, 1, 1});
    write_texels(zeros_, Image(Format::RGBA32F, 1, 1));
    debug_.check("starting OpenGL");
  }

  // What is made of OpenGL objects goes first, while the context is current.
  ~OpenGlDevice() override { context_.try_make_current(); }

  OpenGlDevice(const OpenGlDevice&) = delete;
  OpenGlDevice& operator=(const OpenGlDevice&) = delete;

  std::string description() const override { return "OpenGL, " + renderer_ + ", " + platform_; }
  std::string renderer() const override { return renderer_; }
  std::string version() const override { return version_; }
  GlLimits limits() const override { return limits_; }
  std::string passed_over() const override { return passed_over_; }
  DeviceObjects made() const override { return made_; }
  void finish() override {
    context_.make_current();
    glFinish();
    debug_.check("finishing");
  }
  int max_texture_size() const override { return max_texture_size_; }

  TextureId create_texture(Format format, int width, int height) override {
    context_.make_current();
    if (width < 1 || height < 1 || width > max_texture_size_ || height > max_texture_size_)
      throw Error(ExitCode::WrongUsage, "a texture of " + std::to_string(width) + " x " +
                                            std::to_string(height) + " is not between 1 x 1 and " +
                                            std::to_string(max_texture_size_) + " squared");
    Texture texture = make_texture({format, width, height});
    debug_.check("making a texture of " + std::to_string(width) + " x " + std::to_string(height));
    const auto id = static_cast<TextureId>(++last_texture_);
    textures_.emplace(id, std::move(texture));
    ++made_.textures;
    return id;
  }

  TextureId upload(const Image& image) override {
    const TextureId id = create_texture(image.shape.format, image.width(), image.height());
    try {
      write_texels(texture_of(id), image);
      debug_.check("filling a texture");
    } catch (...) {
      textures_.erase(id);
      throw;
    }
    return id;
  }

  void destroy(TextureId texture) override {
    context_.make_current();
    std::erase_if(framebuffers_, [&](const auto& entry) {
      return std::find(entry.first.begin(), entry.first.end(), texture) != entry.first.end();
    });
    textures_.erase(texture);
    debug_.drop();
  }

  MeshId create_mesh(const MeshData& data) override {
    context_.make_current();
    Mesh mesh = make_mesh(data);
    debug_.check("making a mesh of " + std::to_string(mesh.vertex_count) + " vertices");
    made_.buffers += (mesh.vertices.id() ? 1u : 0u) + (mesh.indices.id() ? 1u : 0u);
    const auto id = static_cast<MeshId>(++last_mesh_);
    meshes_.emplace(id, std::move(mesh));
    return id;
  }

  void update(MeshId id, const MeshData& data) override {
    mesh_of(id);
    context_.make_current();
    update_mesh(meshes_.at(id), data);
    debug_.check("filling a mesh");
  }

  void destroy(MeshId mesh) override {
    context_.make_current();
    meshes_.erase(mesh);
    debug_.drop();
  }

  Image read_back(TextureId texture) override {
    context_.make_current();
    Image image = read_texels(texture_of(texture));
    debug_.check("reading a texture back");
    ++made_.read_backs;
    return image;
  }

  ImageShape shape(TextureId texture) const override { return texture_of(texture).shape; }

  const MeshData::Attribute* find_attribute(MeshId mesh, std::string_view name) const override {
    for (const MeshData::Attribute& attribute : mesh_of(mesh).layout)
      if (attribute.name == name) return &attribute;
    return nullptr;
  }

  PassResult run(const PassRun& run) override {
    validate(run, *this);
    context_.make_current();
    const std::string what = "pass '" + run.definition->name + "'";
    try {
      return checked_run(run, what);
    } catch (...) {
      drop_what_runs_made();
      debug_.forget(what);
      throw;
    }
  }

 private:
  PassResult checked_run(const PassRun& run, const std::string& what) {
    // All that a faultless driver can refuse comes before the queries begin.
    std::vector<const Program*> programs;
    for (const Draw& draw : run.draws) programs.push_back(&program_of(*run.definition, draw.uniforms));
    const GLuint framebuffer = framebuffer_of(run);
    prepare_draws(run, programs);
    debug_.check(what);
    const PassResult submitted = counted(run);
    PassResult result = submitted;
    const bool counts =
        run.definition->count_samples && (meter_.measures() || run.counts_into != OcclusionQuery::None);
    meter_.begin();
    begin_targets(run, framebuffer);
    if (counts) occlusion_.begin(run.counts_into);
    if (run.only_if != OcclusionQuery::None) occlusion_.begin_condition(run.only_if);
    for (std::size_t i = 0; i < run.draws.size(); ++i) {
      if (i == 0 || programs[i] != programs[i - 1]) use(*programs[i], run);
      draw(run, i);
    }
    occlusion_.end_condition();
    occlusion_.end();
    meter_.end(result);
    if (!meter_.measures()) backlog_.add();
    // What the driver counts are corners of quadrilaterals, none where it left them out.
    const bool rectangles = run.definition->topology == Topology::Rectangles;
    if (result.vertices != 0 && (as_quads(*run.definition) || rectangles)) {
      result.vertices = submitted.vertices;
      result.primitives = submitted.primitives;
    }
    if (counts && meter_.measures()) result.samples_passed = occlusion_.samples(run.counts_into).value_or(0);
    if (run.only_if != OcclusionQuery::None && meter_.measures())
      result.left_out = occlusion_.samples(run.only_if) == 0;
    debug_.check(what);
    return result;
  }

  // What a driver has failed to make, or has half made, must not serve the next run.
  void drop_what_runs_made() {
    occlusion_.drop();
    meter_.end_queries();
    backlog_.forget();
    framebuffers_.clear();
    for (auto& [id, mesh] : meshes_) mesh.arrays.clear();
    uniforms_.drop_buffer();
  }

  const Texture& texture_of(TextureId id) const {
    const auto found = textures_.find(id);
    if (found == textures_.end())
      throw Error(ExitCode::InternalError, "a texture that does not exist is used");
    return found->second;
  }

  const Mesh& mesh_of(MeshId id) const {
    const auto found = meshes_.find(id);
    if (found == meshes_.end()) throw Error(ExitCode::InternalError, "a mesh that does not exist is used");
    return found->second;
  }

  // Are the pass's points drawn as quadrilaterals?
  bool as_quads(const PassDefinition& definition) const {
    return definition.topology == Topology::Points && limits_.largest_point < kLargestPointSize;
  }

  Program compiled(const Shader& shader, const std::vector<int>& choices, bool quads) {
    try {
      return make_program(shader, choices, quads ? Stage::VertexOfQuads : Stage::Vertex);
    } catch (...) {
      debug_.forget("shader '" + std::string(shader.name) +
                    "'");  // the compiler's messages, which the Error repeats
      throw;
    }
  }

  // For the choices that a draw's uniform block has made.
  const Program& program_of(const PassDefinition& definition, const std::vector<std::byte>& uniforms) {
    const Shader& shader = *definition.shader;
    std::tuple key{&shader, choices_in(shader, uniforms), as_quads(definition)};
    const auto found = programs_.find(key);
    if (found != programs_.end()) return found->second;
    if (compiling_) compiling_(shader.name);
    Program program = compiled(shader, std::get<1>(key), std::get<2>(key));
    debug_.check("shader '" + std::string(shader.name) + "'");
    ++made_.programs;
    return programs_.emplace(std::move(key), std::move(program)).first->second;
  }

  GLuint framebuffer_of(const PassRun& run) {
    Attachments key = run.colors;
    key.push_back(run.depth);
    const auto found = framebuffers_.find(key);
    if (found != framebuffers_.end()) return found->second.id();
    std::vector<GLuint> names;
    for (const TextureId id : key) names.push_back(id == TextureId::None ? 0 : texture_of(id).object.id());
    ++made_.framebuffers;
    return framebuffers_.emplace(std::move(key), make_framebuffer(names)).first->second.id();
  }

  // Uniform blocks, vertex arrays and the existence of all textures.
  void prepare_draws(const PassRun& run, const std::vector<const Program*>& programs) {
    uniforms_.clear();
    for (std::size_t i = 0; i < run.draws.size(); ++i) {
      const Draw& draw = run.draws[i];
      uniforms_.add(draw.uniforms, programs[i]->uniform_bytes);
      for (const TextureId id : draw.textures)
        if (id != TextureId::None) texture_of(id);
      if (draw.mesh == MeshId::None) continue;
      mesh_of(draw.mesh);
      Mesh& mesh = meshes_.at(draw.mesh);
      const std::pair key{run.definition->shader, as_quads(*run.definition)};
      if (key.second && mesh.indices.id())
        throw Error(ExitCode::InternalError,
                    "points of an indexed mesh cannot be drawn as quadrilaterals, which "
                    "this driver's small points need; list the vertices in order");
      if (mesh.arrays.count(key)) continue;
      mesh.arrays.emplace(key, make_vertex_array(mesh, programs[i]->interface, key.second));
      ++made_.vertex_layouts;
    }
    if (uniforms_.upload()) ++made_.buffers;
  }

  // What is known without the driver, should it not count.
  PassResult counted(const PassRun& run) const {
    PassResult result;
    for (const Draw& draw : run.draws) {
      const Mesh* mesh = draw.mesh == MeshId::None ? nullptr : &mesh_of(draw.mesh);
      const auto loose = static_cast<std::uint64_t>(std::max(0, draw.vertex_count));
      const std::uint64_t corners = mesh ? mesh->corner_count() : loose;
      result.vertices += corners;
      result.primitives += run.definition->topology == Topology::Triangles ? corners / 3 : corners;
    }
    return result;
  }

  void begin_targets(const PassRun& run, GLuint framebuffer) {
    const ImageShape size = size_of_targets(run);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glViewport(0, 0, size.width, size.height);
    open_masks();
    clear_targets(framebuffer, run);
    set_pass_state(*run.definition);
    if (as_quads(*run.definition)) glDisable(GL_CULL_FACE);  // points have no faces
  }

  void use(const Program& program, const PassRun& run) {
    glUseProgram(program.object.id());
    if (!as_quads(*run.definition)) return;
    const ImageShape size = size_of_targets(run);
    glUniform2f(0, static_cast<float>(size.width), static_cast<float>(size.height));  // target_size
  }

  ImageShape size_of_targets(const PassRun& run) const {
    const auto drawn_into = std::find_if(run.colors.begin(), run.colors.end(),
                                         [](TextureId id) { return id != TextureId::None; });
    return shape(drawn_into == run.colors.end() ? run.depth : *drawn_into);
  }

  void draw(const PassRun& run, std::size_t i) {
    const Draw& draw = run.draws[i];
    const GLenum topology = gl_topology(run.definition->topology);
    uniforms_.bind(i);
    for (std::size_t unit = 0; unit < draw.textures.size(); ++unit) {
      const TextureId id = draw.textures[unit];
      const Texture& texture = id == TextureId::None ? zeros_ : textures_.at(id);
      glBindTextureUnit(static_cast<GLuint>(unit), texture.object.id());
    }
    const bool quads = as_quads(*run.definition);
    const Mesh* mesh = draw.mesh == MeshId::None ? nullptr : &meshes_.at(draw.mesh);
    const auto corners = mesh ? static_cast<GLsizei>(mesh->corner_count()) : std::max(0, draw.vertex_count);
    glBindVertexArray(mesh ? mesh->arrays.at({run.definition->shader, quads}).id() : no_vertices_.id());
    if (quads)
      glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, corners);
    else if (mesh && mesh->indices.id())
      glDrawElements(topology, corners, GL_UNSIGNED_INT, nullptr);
    else
      glDrawArrays(topology, 0, run.definition->topology == Topology::Rectangles ? 6 * corners : corners);
  }

  EglContext context_;
  DebugLog debug_;
  std::string platform_, renderer_, version_, passed_over_;
  GlLimits limits_;
  std::function<void(std::string_view)> compiling_;
  RunMeter meter_;
  Backlog backlog_;
  OcclusionQueries occlusion_;
  VertexArrayObject no_vertices_;
  UniformBuffer uniforms_;
  Texture zeros_;
  int max_texture_size_ = 0;
  std::uint32_t last_texture_ = 0, last_mesh_ = 0;
  DeviceObjects made_;
  std::map<TextureId, Texture> textures_;
  std::map<MeshId, Mesh> meshes_;
  // By shader, choices, and whether its points are drawn as quadrilaterals.
  std::map<std::tuple<const Shader*, std::vector<int>, bool>, Program> programs_;
  std::map<Attachments, FramebufferObject> framebuffers_;
};

constexpr const char* kInstead = "; --backend software works";

[[noreturn]] void no_device(const std::string& why) {
  throw Error(ExitCode::BackendUnavailable, why + kInstead);
}

std::vector<EglCandidate> candidates_or_error() {
  try {
    return egl_candidates();
  } catch (const Error& error) {
    no_device("OpenGL cannot be used: " + std::string(error.what()));
  }
}

GlDeviceInfo describe(const EglCandidate& candidate, int index) {
  GlDeviceInfo info;
  info.index = index;
  info.platform = candidate.name;
  try {
    const EglContext context(candidate, false);
    info.vendor = text_of(GL_VENDOR);
    info.renderer = text_of(GL_RENDERER);
    info.version = text_of(GL_VERSION);
    info.reason = unusable(info.renderer);
    if (!info.reason.empty()) info.renderer.clear();
  } catch (const Error& error) {
    info.reason = error.what();
  }
  return info;
}

}  // namespace

}  // namespace gl

std::vector<GlDeviceInfo> list_gl_devices() {
  std::vector<GlDeviceInfo> devices;
  bool any_works = false;
  for (const gl::EglCandidate& candidate : gl::candidates_or_error()) {
    // Asking for a display that is not there makes some drivers print: only when nothing else is
    // left.
    if (any_works && candidate.platform == gl::Platform::DefaultDisplay) continue;
    devices.push_back(gl::describe(candidate, static_cast<int>(devices.size())));
    any_works = any_works || devices.back().reason.empty();
  }
  return devices;
}

std::unique_ptr<GlDevice> make_gl_device(const GlOptions& options) {
  const std::vector<gl::EglCandidate> candidates = gl::candidates_or_error();
  const int count = static_cast<int>(candidates.size());
  if (options.device < -1 || options.device >= count)
    gl::no_device("OpenGL device " + std::to_string(options.device) + " does not exist, the last is " +
                  std::to_string(count - 1));
  std::string reasons;
  for (int i = 0; i < count; ++i) {
    if (options.device >= 0 && i != options.device) continue;
    const gl::EglCandidate& candidate = candidates[static_cast<std::size_t>(i)];
    try {
      return std::make_unique<gl::OpenGlDevice>(candidate, options, reasons);
    } catch (const Error& error) {
      if (reasons.find(error.what()) != std::string::npos) continue;  // said once
      if (!reasons.empty()) reasons += "; ";
      reasons += "device " + std::to_string(i) + ", " + candidate.name + ": " + error.what();
    }
  }
  gl::no_device("no OpenGL 4.5 core context (" + reasons + ")");
}

}  // namespace caustics
