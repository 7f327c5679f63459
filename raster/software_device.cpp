#include "raster/software_device.hpp"

#include <map>
#include <string>
#include <utility>

#include "pipeline/gpu/error.hpp"
#include "pipeline/gpu/stopwatch.hpp"
#include "pipeline/gpu/validate.hpp"
#include "raster/lane_dispatch.hpp"
#include "raster/texel_replay.hpp"
#include "raster/workers.hpp"

namespace caustics {

namespace raster {

namespace {

constexpr int kMaxTextureSize = 16384;

class SoftwareDevice final : public Device {
 public:
  explicit SoftwareDevice(const SoftwareOptions& options)
      : workers_(options.threads),
        lanes_(options.lanes ? *options.lanes : default_lanes()),
        batch_(std::max<std::size_t>(1, options.batch)) {
    if (!is_supported(lanes_))
      throw Error(ExitCode::WrongUsage, "lane width '" + std::string(lanes_name(lanes_)) +
                                            "' is not supported by this processor or build");
  }

  std::string description() const override {
    static constexpr int kWidth[kLanesCount] = {1, 4, 4, 8, 16};
    return "software, " + std::to_string(kWidth[static_cast<int>(lanes_)]) + " lanes (" +
           std::string(lanes_name(lanes_)) + "), " + std::to_string(workers_.threads()) +
           (workers_.threads() == 1 ? " thread" : " threads");
  }

  int max_texture_size() const override { return kMaxTextureSize; }

  TextureId create_texture(Format format, int width, int height) override {
    if (width < 1 || height < 1 || width > kMaxTextureSize || height > kMaxTextureSize)
      throw Error(ExitCode::WrongUsage, "a texture of " + std::to_string(width) + " x " +
                                            std::to_string(height) + " is not between 1 x 1 and " +
                                            std::to_string(kMaxTextureSize) + " squared");
    return insert(Texture(ImageShape{format, width, height}));
  }

  TextureId upload(const Image& image) override { return insert(Texture(image)); }
  TextureId share(const Image& image) override { return insert(Texture::sharing(image)); }

  void destroy(TextureId texture) override { textures_.erase(texture); }

  MeshId create_mesh(const MeshData& mesh) override {
    check_indices(mesh);
    ++made_.buffers;
    const auto id = static_cast<MeshId>(++last_mesh_);
    meshes_.emplace(id, mesh);
    return id;
  }

  void update(MeshId id, const MeshData& data) override {
    check_same_extent(mesh_of(id), data);
    check_indices(data);
    meshes_[id] = data;
  }

  void destroy(MeshId mesh) override { meshes_.erase(mesh); }
  Image read_back(TextureId texture) override {
    ++made_.read_backs;
    return texture_of(texture).image();
  }
  ImageView look_at(TextureId id) override {
    ++made_.read_backs;
    const Texture& texture = texture_of(id);
    return {texture.shape, {texture.values.get(), texture.value_count()}};
  }
  void finish() override {}
  DeviceObjects made() const override { return made_; }
  ImageShape shape(TextureId texture) const override { return texture_of(texture).shape; }

  const MeshData::Attribute* find_attribute(MeshId mesh, std::string_view name) const override {
    for (const MeshData::Attribute& attribute : mesh_of(mesh).layout)
      if (attribute.name == name) return &attribute;
    return nullptr;
  }

  void replay(const PassRun& run, const TargetsBefore& before, const TexelRectangle& where,
              const FragmentVisitor& visit) const {
    validate(run, *this);
    const TextureId target = run.depth != TextureId::None
                                 ? run.depth
                                 : *std::find_if(run.colors.begin(), run.colors.end(),
                                                 [](TextureId id) { return id != TextureId::None; });
    TexelReplay replay(*run.definition, before, shape(target), where, workers_);
    for (std::size_t i = 0; i < run.draws.size(); ++i) {
      ShadedVertices shaded;
      replay.draw(i, prepared_draw(*run.definition, run.draws[i], shaded), shaded, visit);
    }
  }

  PassResult run(const PassRun& run) override {
    const Stopwatch watch;
    validate(run, *this);
    PassResult result = execute(run);
    result.milliseconds = watch.milliseconds();
    result.processor_milliseconds = watch.processor_milliseconds();
    return result;
  }

 private:
  TextureId insert(Texture texture) {
    ++made_.textures;
    const auto id = static_cast<TextureId>(++last_texture_);
    textures_.emplace(id, std::move(texture));
    return id;
  }

  const Texture& texture_of(TextureId id) const {
    const auto found = textures_.find(id);
    if (found == textures_.end())
      throw Error(ExitCode::InternalError, "a texture that does not exist is used");
    return found->second;
  }

  Texture& target_of(TextureId id) {
    Texture& texture = textures_.at(id);
    if (texture.values.get_deleter().is_shared)
      throw Error(ExitCode::InternalError, "a shared image is drawn into");
    return texture;
  }

  static void check_indices(const MeshData& mesh) {
    const std::size_t count = mesh.vertex_count();
    for (const std::uint32_t index : mesh.indices)
      if (index >= count)
        throw Error(ExitCode::InternalError, "a mesh's index " + std::to_string(index) + " is beyond its " +
                                                 std::to_string(count) + " vertices");
  }

  static void check_same_extent(const MeshData& old, const MeshData& data) {
    if (old.floats_per_vertex() == data.floats_per_vertex() && old.vertices.size() == data.vertices.size() &&
        old.indices.size() == data.indices.size())
      return;
    throw Error(ExitCode::InternalError, "a mesh is updated by one of another layout or size");
  }

  const MeshData& mesh_of(MeshId id) const {
    const auto found = meshes_.find(id);
    if (found == meshes_.end()) throw Error(ExitCode::InternalError, "a mesh that does not exist is used");
    return found->second;
  }

  PassResult execute(const PassRun& run) {
    const PassDefinition& definition = *run.definition;
    RenderTarget target;
    for (std::size_t i = 0; i < run.colors.size(); ++i)
      target.colors.push_back({run.colors[i] == TextureId::None ? nullptr : &target_of(run.colors[i]),
                               &definition.writes[i], !run.keep.empty() && run.keep[i]});
    if (definition.depth) {
      target.depth = &target_of(run.depth);
      target.depth_clear = definition.depth->clear;
      target.keep_depth = !run.keep.empty() && run.keep.back();
    }
    PassResult result;
    const auto condition = run.only_if == OcclusionQuery::None ? samples_.end() : samples_.find(run.only_if);
    result.left_out = condition != samples_.end() && condition->second == 0;
    const bool drawn = !run.draws.empty() && !result.left_out;
    if (!drawn) target.clear(workers_);
    for (const RenderTarget::Color& color : target.colors)
      if (drawn && color.texture) color.texture->bring_in(workers_);
    if (drawn && target.depth) target.depth->bring_in(workers_);
    if (drawn) {
      forget_waiting();
      for (const Draw& draw : run.draws) execute_draw(definition, draw, target, result);
      fill_waiting(target, result);
      forget_much();
    }
    if (!definition.count_samples) result.samples_passed = 0;
    if (run.counts_into != OcclusionQuery::None) samples_[run.counts_into] = result.samples_passed;
    return result;
  }

  // Its primitives wait for those of the draws behind it, until they are many.
  void execute_draw(const PassDefinition& definition, const Draw& draw, RenderTarget& target,
                    PassResult& result) {
    const ImageShape size = target.shape();
    const TileGrid grid(size.width, size.height);
    std::size_t place = waiting_.size();
    if (binned_.size() == place) binned_.push_back(std::make_unique<Binned>());
    Binned& own = *binned_[place];
    own.prepared = prepared_draw(definition, draw, own.shaded);
    own.prepared.work.idle_where_zero = idle_where_zero(definition, draw, size);
    std::size_t first = 0;
    do {  // without a primitive too: what is not kept is cleared
      const std::size_t count = std::min(batch_, own.prepared.primitives - first);
      if (waiting_primitives_ + count > batch_ || waiting_bytes_ > kMostKeptOfDraws) {
        fill_waiting(target, result);
        std::swap(binned_.front(), binned_[std::exchange(place, 0)]);
      }
      result.operations += own.prepared.shade(first, count, workers_, own.shaded);
      bin_primitives(own.prepared.primitive_stage, first, count, grid, workers_, own.chunks);
      waiting_.push_back({&own.prepared.work, &own.chunks});
      waiting_primitives_ += count;
      waiting_bytes_ += own.shaded.room * sizeof(float);
      first += count;
    } while (first < own.prepared.primitives);
    result.vertices += own.prepared.corners;
    result.primitives += own.prepared.primitives;
  }

  void fill_waiting(RenderTarget& target, PassResult& result) {
    if (waiting_.empty()) return;
    const ImageShape size = target.shape();
    const TileCounters counters = fill_tiles(waiting_, TileGrid(size.width, size.height), target, workers_);
    target.keep_all();
    result.fragments += counters.fragments;
    result.samples_passed += counters.samples_passed;
    result.operations += counters.operations;
    forget_waiting();
  }

  void forget_waiting() {
    waiting_.clear();
    waiting_primitives_ = waiting_bytes_ = 0;
  }

  PreparedDraw prepared_draw(const PassDefinition& definition, const Draw& draw,
                             const ShadedVertices& shaded) const {
    const MeshData* mesh = draw.mesh == MeshId::None ? nullptr : &mesh_of(draw.mesh);
    return prepare_draw(definition, draw, bound_textures(draw), mesh, lanes_, shaded);
  }

  // The next pass finds the memory of this one there, unless it was much.
  void forget_much() {
    std::size_t bytes = 0;
    for (const auto& draw : binned_) {
      bytes += draw->shaded.room * sizeof(float);
      // The first one's records take no more than those of a batch.
      if (draw != binned_.front())
        for (const BinnedChunk& chunk : draw->chunks) bytes += chunk.bytes();
    }
    if (bytes > kMostKeptOfDraws) binned_.clear();
  }

  std::vector<const Texture*> idle_where_zero(const PassDefinition& definition, const Draw& draw,
                                              const ImageShape& size) const {
    std::vector<const Texture*> found;
    for (std::size_t i = 0; i < definition.reads.size(); ++i) {
      if (!definition.reads[i].discards_where_zero || draw.textures[i] == TextureId::None) continue;
      const Texture& texture = texture_of(draw.textures[i]);
      if (texture.shape.width == size.width && texture.shape.height == size.height) found.push_back(&texture);
    }
    return found;
  }

  std::vector<TextureView> bound_textures(const Draw& draw) const {
    static constexpr float kZeros[4] = {0.0f, 0.0f, 0.0f, 0.0f};
    std::vector<TextureView> views;
    for (const TextureId id : draw.textures) {
      if (id == TextureId::None) {
        views.push_back({kZeros, 1, 1, 4});
        continue;
      }
      const Texture& texture = texture_of(id);
      views.push_back({texture.values.get(), texture.shape.width, texture.shape.height, texture.channels()});
    }
    return views;
  }

  struct Binned {
    ShadedVertices shaded;
    PreparedDraw prepared;  // of the vertices above
    std::vector<BinnedChunk> chunks;
  };

  Workers workers_;
  Lanes lanes_;
  std::size_t batch_;  // primitives
  std::uint32_t last_texture_ = 0, last_mesh_ = 0;
  DeviceObjects made_;
  std::map<TextureId, Texture> textures_;
  std::map<MeshId, MeshData> meshes_;
  // Of the pass that runs: its draws, and which of their stretches wait to be drawn.
  std::vector<std::unique_ptr<Binned>> binned_;
  std::vector<BinnedDraw> waiting_;
  std::size_t waiting_primitives_ = 0, waiting_bytes_ = 0;
  std::map<OcclusionQuery, std::uint64_t> samples_;  // that passed, by the query they were counted into
};

}  // namespace

}  // namespace raster

void replay_fragments(const Device& software, const PassRun& run, const TargetsBefore& before,
                      const TexelRectangle& where, const FragmentVisitor& visit) {
  const auto* device = dynamic_cast<const raster::SoftwareDevice*>(&software);
  if (!device) throw Error(ExitCode::InternalError, "texels are drawn again by the software device alone");
  device->replay(run, before, where, visit);
}

std::size_t draw_bytes(const PassDefinition& definition, std::size_t vertices, std::size_t primitives) {
  using namespace raster;
  const bool triangles = definition.topology == Topology::Triangles;
  const auto varyings = static_cast<std::size_t>(interface_of(*definition.shader).varying_components());
  const std::size_t batch = std::min(primitives, kPrimitivesPerBatch);
  const std::size_t shaded = vertices > 0 ? vertices : batch * (triangles ? 3 : 1);
  const std::size_t record =
      triangles ? sizeof(TriangleRecord) + (2 + varyings) * sizeof(Plane) : sizeof(PointRecord);
  return shaded * (ShadedVertices::kHeader + varyings) * sizeof(float) +
         batch * (record + sizeof(std::uint32_t));
}

std::unique_ptr<Device> make_software_device(const SoftwareOptions& options) {
  if (options.threads < 0)
    throw Error(ExitCode::WrongUsage,
                "the number of threads is " + std::to_string(options.threads) + "; give 0 or more");
  return std::make_unique<raster::SoftwareDevice>(options);
}

}  // namespace caustics
