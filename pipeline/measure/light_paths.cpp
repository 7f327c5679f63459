#include "pipeline/measure/light_paths.hpp"

#include <algorithm>
#include <bit>
#include <map>
#include <utility>

#include "pipeline/effects/branches.hpp"
#include "pipeline/gpu/device.hpp"
#include "pipeline/gpu/interrupt.hpp"
#include "pipeline/scene/exact.hpp"

namespace caustics {

namespace {

// How often a part passes something straight: before its first caster, or where it goes astray.
constexpr int kMostPassed = 256;
// Parts that a step takes, and in a row of its textures.
constexpr std::size_t kMostAtOnce = 16384, kInRow = 128;
// The largest share that is drawn for a facet: less than 1 in single precision too.
constexpr double kMostShare = 1.0 - 0x1p-23;

double largest(const glm::dvec3& v) { return std::max({v.x, v.y, v.z}); }

// Random numbers by counter: SplitMix64 (Steele, Lea, Flood 2014).
std::uint64_t mixed(std::uint64_t x) {
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ull;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebull;
  return x ^ (x >> 31);
}

const Pass& light_step_of(const Registry& registry) {
  for (const Pass& pass : registry)
    if (pass.drawn_for.front().each == Each::Rays) return pass;
  throw Error(ExitCode::InternalError, "the registry has no pass that follows rays");
}

std::vector<int> casters_of(const Effects& effects) {
  std::vector<int> meshes;
  for (int m = 0; m < static_cast<int>(effects.surfaces.size()); ++m)
    if (is_caster(effects.surfaces[static_cast<std::size_t>(m)].role)) meshes.push_back(m);
  return meshes;
}

}  // namespace

LightRay light_ray(const Light& light, const View& view, int side, int x, int y) {
  LightRay ray{.origin = view.origin, .direction = view.forward, .emitter = light.emitter};
  const glm::dvec2 middle(x + 0.5, y + 0.5);
  if (view.cube) {
    const int column = x / view.cube->tile_width(), row = y / view.cube->tile_height();
    const int face = 3 * row + column;
    const glm::dvec2 corner = view.cube->texel(glm::dvec2(-1.0), face);
    const glm::dvec2 tangents =
        (middle - corner) / glm::dvec2(view.cube->face_width(), view.cube->face_height()) * 2.0 - 1.0;
    const glm::dvec3 q = turned_from_face({tangents.x, tangents.y, 1.0}, face);
    ray.direction = exact::normalise((view.right * q.x + view.up * q.y) + view.forward * q.z, view.forward);
    return ray;
  }
  const glm::dvec2 window =
      view.window_lower + (view.window_upper - view.window_lower) * (middle / static_cast<double>(side));
  const glm::dvec3 aside = view.right * window.x + view.up * window.y;
  if (view.perspective) {
    ray.direction = exact::normalise(view.forward + aside, view.forward);
  } else {
    ray.origin = view.origin + aside;
  }
  return ray;
}

struct LightPaths::Part {
  glm::vec3 start{0.0f}, direction{0.0f};
  glm::vec4 media{0.0f};  // the bodies that it is in (passes/shared/media.glsl)
  float own = 0.0f;       // number of the triangle where it starts, plus 1
  glm::dvec3 flux{0.0};
  double whole = 0.0;  // the largest channel of what its ray began with
  std::size_t ray = 0;
  int first = -1;        // LightLanding::first
  int surfaces = 0;      // met so far
  int passed = 0;        // straight, of them
  bool followed = true;  // by the passes too, so far
  bool let_go = false;   // the passes land it on the next receiver, whatever caster stands before it
  bool astray = false;   // it is what they land so, and another caster has stood there
  std::uint64_t drawn = 0;

  // In [0, 1).
  double draw() { return static_cast<double>(mixed(drawn += 0x9e3779b97f4a7c15ull) >> 11) * 0x1p-53; }
};

struct LightPaths::Meeting {
  glm::vec3 point{0.0f};
  int number = -1;        // of the triangle, -1: there is none
  glm::dvec3 left{1.0};   // share of the light that is left on the way there
  bool front = false;     // it comes from outside
  bool hole = false;      // there is nothing, but for an alpha mask
  double mirrored = 0.0;  // share of what comes that has no other way than back
  glm::vec3 back{0.0f}, onward{0.0f};
  glm::dvec3 light_back{0.0}, light_onward{0.0};  // of what goes that way, what is left
  glm::vec4 media_onward{0.0f};
};

LightPaths::LightPaths(const RayTables& tables, Effects effects, const Settings& settings,
                       const Registry& registry)
    : tables_(tables),
      effects_(std::move(effects)),
      settings_(settings),
      pass_(light_step_of(registry)),
      definition_(definition_of(pass_, effects_)),
      medium_(effects_.medium.active ? medium_bounds(tables.scene()) : Bounds{}) {}

bool LightPaths::casters_block(const glm::dvec3& p, const glm::dvec3& direction, double distance) const {
  if (!casters_) casters_.emplace(tables_.scene(), casters_of(effects_));
  const auto caster = casters_->nearest(p + direction * static_cast<double>(tables_.touch()), direction);
  return caster && caster->distance < distance;
}

glm::dvec3 LightPaths::left_by_air(const Part& part, const Meeting& met) const {
  if (!effects_.medium.active) return glm::dvec3(1.0);
  const glm::dvec3 start(part.start), way = glm::dvec3(met.point) - start;
  double from = 0.0, to = 1.0;
  for (int axis = 0; axis < 3; ++axis) {
    if (way[axis] == 0.0) continue;
    const double a = (medium_.lower[axis] - start[axis]) / way[axis];
    const double b = (medium_.upper[axis] - start[axis]) / way[axis];
    from = std::max(from, std::min(a, b));
    to = std::min(to, std::max(a, b));
  }
  const double metres = exact::length(way) * std::max(to - from, 0.0);
  const glm::dvec3 extinction(tables_.scene().medium.extinction());
  return {exact::exp(-extinction.x * metres), exact::exp(-extinction.y * metres),
          exact::exp(-extinction.z * metres)};
}

// Its targets serve many steps, and have one of few heights.
class LightPaths::Stepping {
 public:
  Stepping(const LightPaths& paths, double bend) : paths_(paths) {
    const Branch branch{.bend = bend};
    const RayTables& tables = paths.tables_;
    draw_ = {.vertex_count = 3,
             .uniforms = paths.pass_.uniforms({.settings = &paths.settings_,
                                               .effects = &paths.effects_,
                                               .branch = &branch,
                                               .first_receiver = tables.first_receiver(),
                                               .first_uv = tables.first_uv(),
                                               .touch = tables.touch()}),
             .textures = {TextureId::None, tables.materials(), tables.nodes(), tables.triangles(),
                          tables.normals(), tables.texels()}};
  }

  std::vector<Meeting> operator()(std::span<const Part> parts) {
    Device& device = paths_.tables_.device();
    const int height = static_cast<int>(std::bit_ceil((parts.size() + kInRow - 1) / kInRow));
    const OwnedTexture rays(device, device.upload(image_of(parts, height)));
    draw_.textures.front() = rays.id();
    const PassRun run{.definition = &paths_.definition_, .colors = targets(height), .draws = {draw_}};
    device.run(run);
    std::vector<ImageView> told;
    for (const TextureId color : run.colors) told.push_back(device.look_at(color));
    std::vector<Meeting> meetings;
    for (std::size_t i = 0; i < parts.size(); ++i) meetings.push_back(meeting_at(told, i));
    return meetings;
  }

 private:
  static Image image_of(std::span<const Part> parts, int height) {
    Image image(Format::RGBA32F, static_cast<int>(kInRow), 4 * height);
    const std::size_t block = kInRow * static_cast<std::size_t>(height);
    for (std::size_t i = 0; i < parts.size(); ++i) {
      Part part = parts[i];
      const double share = std::min(part.draw(), kMostShare), turn = part.draw();
      const glm::vec4 texels[] = {
          {part.start, part.own}, {part.direction, 1.0f}, part.media, {share, turn, 0.0f, 0.0f}};
      for (std::size_t k = 0; k < 4; ++k)
        for (int c = 0; c < 4; ++c)
          image.values[4 * (k * block + i) + static_cast<std::size_t>(c)] = texels[k][c];
    }
    return image;
  }

  std::vector<TextureId> targets(int height) {
    std::vector<OwnedTexture>& owned = targets_[height];
    owned.reserve(paths_.definition_.writes.size());  // each has its owner before the list may fail to grow
    std::vector<TextureId> ids;
    for (std::size_t k = 0; k < paths_.definition_.writes.size(); ++k) {
      Device& device = paths_.tables_.device();
      if (owned.size() == k)
        owned.emplace_back(device, device.create_texture(paths_.definition_.writes[k].format,
                                                         static_cast<int>(kInRow), height));
      ids.push_back(owned[k].id());
    }
    return ids;
  }

  static Meeting meeting_at(const std::vector<ImageView>& told, std::size_t i) {
    const auto texel = [&](std::size_t k) {
      const auto v = told[k].values.subspan(4 * i, 4);
      return glm::vec4(v[0], v[1], v[2], v[3]);
    };
    const glm::vec4 met = texel(0), left = texel(1), back = texel(2), onward = texel(4);
    return {.point = met,
            .number = static_cast<int>(met.w) - 1,
            .left = glm::dvec3(left),
            .front = left.w > 0.0f,
            .hole = onward.w > 0.0f,
            .mirrored = static_cast<double>(back.w),
            .back = back,
            .onward = onward,
            .light_back = glm::dvec3(texel(3)),
            .light_onward = glm::dvec3(texel(5)),
            .media_onward = texel(6)};
  }

  const LightPaths& paths_;
  Draw draw_;
  std::map<int, std::vector<OwnedTexture>> targets_;  // by height
};

class LightPaths::Following {
 public:
  Following(const LightPaths& paths, std::span<const LightRay> rays, std::vector<LightLanding>& landings,
            std::vector<LightLanding>* astray)
      : paths_(paths), rays_(rays), landings_(landings), astray_(astray) {
    // From the back, so that the first ray's light is the first to be followed.
    for (std::size_t i = rays.size(); i-- > 0;) {
      const LightRay& ray = rays[i];
      waiting_.push_back({.start = ray.origin,
                          .direction = ray.direction,
                          .own = static_cast<float>(ray.own + 1),
                          .flux = ray.flux,
                          .whole = largest(ray.flux),
                          .ray = i,
                          .drawn = ray.key * 0x9e3779b97f4a7c15ull});
    }
  }

  // On their way straight through all casters.
  void let_astray() {
    for (Part& part : waiting_) part.astray = true, part.first = 0;
  }

  void follow(double bend) {
    Stepping step(paths_, bend);
    std::vector<Part> parts;
    while (!waiting_.empty()) {
      stop_if_interrupted();
      const std::size_t left = waiting_.size() - std::min(waiting_.size(), kMostAtOnce);
      parts.assign(waiting_.rbegin(), waiting_.rend() - static_cast<std::ptrdiff_t>(left));
      waiting_.resize(left);
      const std::vector<Meeting> meetings = step(parts);
      for (std::size_t i = 0; i < parts.size(); ++i)
        if (meetings[i].number >= 0) arrive(parts[i], meetings[i]);
    }
  }

 private:
  void arrive(Part part, const Meeting& met) {
    const int mesh = paths_.tables_.mesh_of(met.number);
    const bool receiver = met.number >= paths_.tables_.first_receiver();
    part.flux *= met.left;
    if (part.media.x == 0.0f) part.flux *= paths_.left_by_air(part, met);
    if (part.first < 0) {
      // Nothing stands before casters but what they are lit through.
      if (receiver || met.hole || mesh == rays_[part.ray].emitter) return pass_straight(part, met, receiver);
      if (!is_caster(paths_.effects_.surfaces[static_cast<std::size_t>(mesh)].role))
        return pass_pane(part, met);
      part.first = mesh;
      part.whole = largest(part.flux);
    }
    if (receiver) return land(part, met, mesh);
    if (part.astray) return pass_straight(part, met, false);
    if (part.let_go && astray_) {
      Part other = part;
      other.astray = true;
      pass_straight(other, met, false);
    }
    meet(part, met, mesh);
  }

  void land(const Part& part, const Meeting& met, int mesh) {
    if (!(largest(part.flux) > 0.0)) return;
    (part.astray ? *astray_ : landings_)
        .push_back({.position = glm::dvec3(met.point),
                    .flux = part.flux,
                    .followed = part.let_go && !part.astray,
                    .surfaces = part.surfaces,
                    .mesh = mesh,
                    .triangle = met.number,
                    .front = met.front,
                    .ray = part.ray,
                    .first = part.first});
  }

  // `beyond`: and all that lies in the same place.
  void pass_straight(Part part, const Meeting& met, bool beyond) {
    if (++part.passed > kMostPassed) return;
    part.start = met.point + part.direction * (beyond ? 2.0f * paths_.tables_.touch() : 0.0f);
    part.own = static_cast<float>(met.number + 1);
    waiting_.push_back(part);
  }

  // The light that a pane before casters mirrors is not followed.
  void pass_pane(Part part, const Meeting& met) {
    part.flux *= met.light_onward * (1.0 - met.mirrored);
    part.whole = largest(part.flux);
    pass_straight(part, met, false);
  }

  void meet(const Part& before, const Meeting& met, int mesh) {
    const SurfaceRole& surface = paths_.effects_.surfaces[static_cast<std::size_t>(mesh)];
    Part part = before;
    part.start = met.point;
    part.own = static_cast<float>(met.number + 1);
    ++part.surfaces;
    part.draw(), part.draw();  // its facet
    const double r = met.mirrored, weaker = std::min(r, 1.0 - r) * largest(part.flux);
    const bool both = weaker > kWeakShare * part.whole && part.surfaces <= kBothWays;
    const bool mirrors = both || r == 1.0 || (r > 0.0 && part.draw() < r);
    const bool crosses = both || !mirrors;
    Part onward = part;
    if (mirrors) {
      part.drawn = mixed(part.drawn);
      part.flux *= met.light_back * (both ? r : 1.0);
      part.direction = met.back;
      send(part, surface, false, met.front);
    }
    if (crosses) {
      onward.flux *= met.light_onward * (both ? 1.0 - r : 1.0);
      onward.direction = met.onward;
      onward.media = met.media_onward;
      send(onward, surface, true, met.front);
    }
  }

  void send(Part part, const SurfaceRole& surface, bool crosses, bool front) {
    const bool mirror = surface.role == Role::Mirror, solid = surface.two_interfaces;
    const bool in = part.surfaces == 1 && (crosses != mirror || paths_.effects_.reflections.active);
    const bool out = part.surfaces == 2 && solid && crosses && !front;
    part.followed = part.followed && (in || out);
    part.let_go = part.followed && (out || !crosses || !solid);
    if (part.surfaces < kMostSurfaces && largest(part.flux) >= kLeastShare * part.whole &&
        largest(part.flux) > 0.0)
      waiting_.push_back(part);
  }

  const LightPaths& paths_;
  std::span<const LightRay> rays_;
  std::vector<LightLanding>& landings_;
  std::vector<LightLanding>* astray_;
  std::vector<Part> waiting_;
};

void LightPaths::follow(std::span<const LightRay> rays, std::vector<LightLanding>& landings, double bend,
                        std::vector<LightLanding>* astray) const {
  Following(*this, rays, landings, astray).follow(bend);
}

std::vector<LightLanding> LightPaths::first_receivers(std::span<const LightRay> rays) const {
  std::vector<LightLanding> met;
  Following following(*this, rays, met, &met);
  following.let_astray();
  following.follow(0.0);
  return met;
}

}  // namespace caustics
