#include "pipeline/renderer/light_pilot.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>

#include "pipeline/effects/backdrop.hpp"
#include "pipeline/effects/cascades.hpp"
#include "pipeline/gpu/device.hpp"
#include "pipeline/measure/ledger.hpp"
#include "pipeline/measure/light_paths.hpp"
#include "pipeline/plan/frame_plan.hpp"
#include "pipeline/renderer/run_plan.hpp"
#include "pipeline/scene/defaults.hpp"
#include "pipeline/scene/exact.hpp"
#include "pipeline/settings/settings.hpp"
#include "pipeline/settings/splat_kernel.hpp"
#include "pipeline/views/all_around.hpp"
#include "pipeline/views/cascades.hpp"
#include "pipeline/views/cone_range.hpp"
#include "pipeline/views/landing_window.hpp"

namespace caustics {

namespace {

// A window that nothing lies beside.
constexpr double kEverywhere = 1e12;
// Of the share that may fall outside of a map, where the map has a cascade.
constexpr double kCascadedShare = 0.25;
// What a window is widened by for its splats at most: a map of few texels is no kernel's width. Beyond, the
// ledger's kernel_edge has it.
constexpr double kWidestMargin = 1.0;
// The coarse run that looks for landings.
constexpr int kCoarseGrid = 96, kCoarseMap = 256, kCoarseIterations = 8;

// Extent of something in window coordinates and along z.
struct Extents {
  glm::dvec2 lower{std::numeric_limits<double>::infinity()};
  glm::dvec2 upper{-std::numeric_limits<double>::infinity()};
  double nearest = std::numeric_limits<double>::infinity();
  double farthest = -std::numeric_limits<double>::infinity();
  bool empty() const { return lower.x > upper.x; }
  void add(const glm::dvec2& window, double z) {
    lower = glm::min(lower, window);
    upper = glm::max(upper, window);
    nearest = std::min(nearest, z);
    farthest = std::max(farthest, z);
  }
  void add(const Extents& other) {
    lower = glm::min(lower, other.lower);
    upper = glm::max(upper, other.upper);
    nearest = std::min(nearest, other.nearest);
    farthest = std::max(farthest, other.farthest);
  }
};

void add_point(Extents& extents, const View& axes, const glm::dvec3& p, double closest) {
  glm::dvec3 q = axes.coordinates(p);
  // What lies beside or behind a point light is seen at the widest angle.
  if (axes.perspective && q.z < closest) q.z = closest;
  glm::dvec2 w = axes.window(q);
  if (axes.perspective) w = glm::clamp(w, glm::dvec2(-kWidestTangent), glm::dvec2(kWidestTangent));
  extents.add(w, q.z);
}

Extents extents_of(const Mesh& mesh, const View& axes, double closest) {
  Extents extents;
  for (const Vertex& v : mesh.vertices) add_point(extents, axes, glm::dvec3(v.position), closest);
  return extents;
}

// `reach`: how far from the light anything lies. Coordinates are rounded to some ulps of it, and what is
// flat across the light has no depth of its own to spare.
void set_depth(View& view, double nearest, double farthest, double reach) {
  const double slack = std::max(1e-3 * (farthest - nearest), 4e-6 * std::fabs(reach));
  view.near = nearest - slack;
  view.far = farthest + slack;
  if (view.perspective) view.near = std::max(view.near, view.far * 1e-4);
}

struct LightExtents {
  View axes;
  Extents casters, receivers, occluders, panes, everything;
};

// What of the casters a spot light's cone can light, so that a narrow cone gets the whole grid.
void cut_to_cone(Extents& casters, const View& axes, const Light& light) {
  if (light.type != LightType::Spot || casters.empty()) return;
  for (int axis = 0; axis < 2; ++axis) {
    const std::optional<glm::dvec2> cone =
        cone_range(axes, axis, light.direction, static_cast<double>(light.outer_cone));
    if (!cone || cone->x >= casters.upper[axis] || cone->y <= casters.lower[axis]) continue;
    casters.lower[axis] = std::max(casters.lower[axis], cone->x);
    casters.upper[axis] = std::min(casters.upper[axis], cone->y);
  }
}

LightExtents measure(const Scene& scene, const Effects& effects, const Light& light) {
  LightExtents result;
  const Bounds bounds = bounds_of(scene);
  Bounds casters;
  const auto shines = [&](std::size_t mesh) { return light.emitter == static_cast<int>(mesh); };
  for (std::size_t i = 0; i < scene.meshes.size(); ++i)
    if (is_caster(effects.surfaces[i].role) && !shines(i)) casters.add(bounds_of(scene.meshes[i]));
  const double radius = std::max(bounds.radius(), 1e-9);
  double closest = 0.0;
  if (light.type == LightType::Directional) {
    result.axes = view_along(bounds.centre() - light.direction * (radius * 1.01), light.direction);
  } else {
    glm::dvec3 target = casters.empty() ? bounds.centre() : casters.centre();
    // What an emitter turns away from it does not light.
    if (light.lambertian && exact::dot(target - light.position, light.direction) <= 0.0)
      target = light.position + light.direction * radius;
    result.axes = view_along(light.position, exact::normalise(target - light.position, light.direction));
    result.axes.perspective = true;
    closest = 1e-3 * std::max(exact::length(target - light.position), 1e-3 * radius);
  }
  for (std::size_t i = 0; i < scene.meshes.size(); ++i) {
    if (shines(i)) continue;
    const Extents extents = extents_of(scene.meshes[i], result.axes, closest);
    result.everything.add(extents);
    if (is_caster(effects.surfaces[i].role)) {
      result.casters.add(extents);
    } else if (effects.surfaces[i].role == Role::ThinPane) {
      result.panes.add(extents);
    } else {
      result.receivers.add(extents);
      if (!is_backdrop(scene, i, light)) result.occluders.add(extents);
    }
  }
  cut_to_cone(result.casters, result.axes, light);
  return result;
}

// The views before anything is known of the landings: the receiver map sees everything.
LightViews widest_views(const LightExtents& extents, const Effects& effects, int grid) {
  LightViews views{extents.axes, extents.axes, extents.axes, extents.axes,
                   extents.axes, 0.0,          extents.axes, {}};
  const Extents& shadow = extents.occluders.empty() ? extents.everything : extents.occluders;
  const double reach = extents.everything.farthest;
  if (!shadow.empty()) {
    set_window(views.shadow, {shadow.lower, shadow.upper}, 0.01);
    set_depth(views.shadow, extents.everything.nearest, reach, reach);
  }
  if (!extents.panes.empty()) {
    set_window(views.panes, {extents.panes.lower, extents.panes.upper}, 0.01);
    set_depth(views.panes, extents.everything.nearest, reach, reach);
  }
  if (extents.casters.empty()) return views;
  set_window(views.caster, {extents.casters.lower, extents.casters.upper}, 4.0 / grid);
  set_depth(views.caster, extents.everything.nearest, extents.casters.farthest, reach);
  Extents all = extents.casters;
  if (!extents.receivers.empty()) all.add(extents.receivers);
  set_window(views.receiver, {all.lower, all.upper}, 0.01);
  set_depth(views.receiver, all.nearest, all.farthest, reach);
  views.casters_nearest = extents.casters.nearest;
  views.column = views.caster;
  if (!effects.mirrors.active && !effects.reflections.active) {
    views.column.window_lower = glm::dvec2(-kEverywhere);
    views.column.window_upper = glm::dvec2(kEverywhere);
  }
  views.caustic = views.receiver;
  return views;
}

void add_landings(const Image& landing, const Image& flux, const View& view,
                  std::vector<WeightedPoint>& points) {
  // What x and y are made of before they are rounded; how far back a parallel light stands is no part of
  // them.
  const double origin = view.perspective ? exact::length(view.origin)
                                         : std::max(std::fabs(exact::dot(view.right, view.origin)),
                                                    std::fabs(exact::dot(view.up, view.origin)));
  for (int y = 0; y < landing.height(); ++y)
    for (int x = 0; x < landing.width(); ++x) {
      if (!is_drawn(static_cast<LandingStatus>(static_cast<int>(landing.at(x, y, 3))))) continue;
      const glm::dvec3 p{landing.at(x, y, 0), landing.at(x, y, 1), landing.at(x, y, 2)};
      const glm::dvec3 q = view.coordinates(p);
      const double w = view.perspective ? q.z : 1.0;
      points.push_back(
          {.window = view.window(q),
           .weight = static_cast<double>(std::max({flux.at(x, y, 0), flux.at(x, y, 1), flux.at(x, y, 2)})),
           .rounding = w > 0.0 ? 0x1p-24 * (exact::length(p) + origin) / w : 0.0});
    }
}

// Draws the caustic view in to the landings, and the receiver view to them and the casters.
// `flat`: the receivers are one plane.
void fit_to_landings(LightViews& views, const std::vector<WeightedPoint>& points, const Settings& settings,
                     double margin, bool flat) {
  views.cascade.reset();
  if (points.empty()) return;
  const LandedFlux landed(points);
  const double shortest = landed.shortest_side(settings.map);
  set_window(views.caustic, landed.window(0.25 * settings.outside_share), margin, shortest);
  if (can_have_cascades(settings)) views.cascade = cascade_view(views.caustic, landed, margin, shortest);
  // Where a cascade shows the bright part, the map around it can be wider and lose less; but the receiver map
  // would have to be as wide, and on receivers that are not flat its texels tell where light lands.
  if (views.cascade && flat)
    set_window(views.caustic, landed.window(0.25 * kCascadedShare * settings.outside_share), margin,
               shortest);
  views.receiver.window_lower = glm::min(views.caustic.window_lower, views.caster.window_lower);
  views.receiver.window_upper = glm::max(views.caustic.window_upper, views.caster.window_upper);
}

}  // namespace

// Runs the passes that lead to the landings on small maps.
class LandingScout {
 public:
  LandingScout(const SceneOnDevice& scene, const Settings& settings, const Registry& registry)
      : scene_(scene), registry_(registry), settings_(settings) {
    settings_.grid = std::min<int>(settings.grid, kCoarseGrid);
    settings_.map = std::min<int>(settings.map, kCoarseMap);
    settings_.iterations = std::max(settings.iterations, kCoarseIterations);
    settings_.estimator = Estimator::Secant;
  }

  // Plans for what the scene calls for now. Earlier textures are used again where they fit.
  void plan(const Effects& effects) {
    effects_ = &effects;
    FramePlan plan = make_plan(scene_.scene(), effects, settings_, registry_,
                               {.textures = {kLanding, kLandingFlux}, .light_by_light = true});
    if (plan.textures != plan_.textures) targets_.reset();
    plan_ = std::move(plan);
  }

  bool finds_anything(int light) const {
    return plan_.find(branch_texture(kLanding, light, effects_->branches.front())) >= 0;
  }

  // `done` hears of each light when its passes have run, and may change its views then.
  void run(const std::vector<LightViews>& views, const std::function<void(int light)>& done) {
    if (!targets_) targets_ = std::make_unique<FrameTargets>(plan_, scene_.device());
    run_plan(plan_, registry_, scene_, *targets_,
             {.settings = &settings_, .effects = effects_, .views = &views, .camera = {}},
             [&](const PlannedPass& pass, const PassResult&, std::size_t, std::size_t) {
               if (pass.ends_light) done(pass.light);
               return true;
             });
  }

  // Of a light that is just done: each branch's landings and their flux.
  void show(int light, const std::function<void(const Image& landing, const Image& flux)>& to) const {
    for (const Branch& branch : effects_->branches) {
      const auto image = [&](const char* name) {
        return scene_.device().read_back((*targets_)[plan_.find(branch_texture(name, light, branch))]);
      };
      to(image(kLanding), image(kLandingFlux));
    }
  }

 private:
  const SceneOnDevice& scene_;
  const Effects* effects_ = nullptr;
  const Registry& registry_;
  Settings settings_;
  FramePlan plan_;
  std::unique_ptr<FrameTargets> targets_;
};

namespace {

// Rays a side by which it is found how light goes on: a share of 5 % is known to 0.5 % by as many. Each lies
// somewhere else in its square of kPlaces a side, so that no pattern of the casters' own is met at its crests
// alone.
constexpr int kRaysASide = 48, kPlaces = 16;

void add_shares(const LightPaths& paths, const Light& light, int number, const View& caster,
                std::vector<FurtherShare>& shares) {
  struct Landed {
    double all = 0.0, simple = 0.0;  // through two surfaces or one, or off the first
  };
  std::map<int, Landed> landed;
  double whole = 0.0;
  std::vector<LightLanding> landings;
  for (int y = 0; y < kRaysASide; ++y)
    for (int x = 0; x < kRaysASide; ++x) {
      const int side = kRaysASide * kPlaces;
      const int column = x * kPlaces + (5 * x + 7 * y) % kPlaces,
                row = y * kPlaces + (11 * x + 3 * y) % kPlaces;
      const int texels = caster.cube ? caster.cube->side : side;
      LightRay ray = light_ray(light, caster, texels, column * texels / side, row * texels / side);
      ray.key = static_cast<std::uint64_t>(y) * kRaysASide + static_cast<std::uint64_t>(x) + 1;
      landings.clear();
      const int mesh = paths.follow(ray, landings);
      for (const LightLanding& landing : landings) {
        const double flux = (landing.flux.x + landing.flux.y) + landing.flux.z;
        landed[mesh].all += flux;
        if (landing.followed || landing.surfaces == 1) landed[mesh].simple += flux;
        whole += flux;
      }
    }
  for (const auto& [mesh, sum] : landed)
    shares.push_back({number, mesh, 1.0 - sum.simple / sum.all, sum.all / whole});
}

}  // namespace

LightPilot::LightPilot(const SceneOnDevice& scene, const Registry& registry)
    : scene_(scene), registry_(registry) {}

LightPilot::~LightPilot() = default;

// Runs the scout twice: first with everything in view, then again with the maps drawn in, for finer
// receivers.
void LightPilot::fit_to_scouted(const Effects& effects, const Settings& settings,
                                std::vector<LightViews>& views, std::vector<LandingSurvey>* surveys) {
  if (!scout_) scout_ = std::make_unique<LandingScout>(scene_, settings, registry_);
  LandingScout& scout = *scout_;
  scout.plan(effects);
  const auto fitted = [&](int i) {
    return scout.finds_anything(i) && effects.lights[static_cast<std::size_t>(i)].all_around.empty();
  };
  bool any = false;
  for (int i = 0; i < static_cast<int>(views.size()); ++i) any |= fitted(i);
  if (!any) return;
  const double kernel_texels = splat_kernel(settings).radius + 2.0;
  for (const double margin : {0.5, std::min(0.03 + 2.0 * kernel_texels / settings.map, kWidestMargin)})
    scout.run(views, [&](int i) {
      if (!fitted(i)) return;
      const auto light = static_cast<std::size_t>(i);
      std::vector<WeightedPoint> points;
      LandingSurvey found;
      scout.show(i, [&](const Image& landing, const Image& flux) {
        add_landings(landing, flux, views[light].caustic, points);
        if (surveys) found.add(survey_landings(landing, flux, views[light].caustic));
      });
      fit_to_landings(views[light], points, settings, margin, effects.receivers_are_one_plane);
      if (surveys) (*surveys)[light] = std::move(found);
    });
}

std::vector<LightViews> LightPilot::fit(const Effects& effects, const Settings& settings,
                                        std::vector<LandingSurvey>* surveys) {
  std::vector<LightViews> views;
  for (const Light& light : scene_.scene().lights) {
    if (!effects.lights[views.size()].all_around.empty()) {
      views.push_back(views_all_around(scene_.scene(), effects, settings, light));
      continue;
    }
    views.push_back(widest_views(measure(scene_.scene(), effects, light), effects, settings.grid));
  }
  if (surveys) surveys->assign(views.size(), {});
  if (!settings.shared_views) {
    fit_to_scouted(effects, settings, views, surveys);
    return views;
  }
  for (LightViews& f : views) {
    f.caustic.window_lower = f.receiver.window_lower = f.caster.window_lower;
    f.caustic.window_upper = f.receiver.window_upper = f.caster.window_upper;
  }
  return views;
}

std::vector<FurtherShare> LightPilot::further_shares(const Effects& effects, const Settings& settings) const {
  const Scene& scene = scene_.scene();
  const LightPaths paths(scene, effects);
  std::vector<FurtherShare> shares;
  std::set<int> sources;
  for (int i = 0; i < static_cast<int>(scene.lights.size()); ++i) {
    const Light& light = scene.lights[static_cast<std::size_t>(i)];
    if (!throws_caustic(effects, i) || (light.source >= 0 && !sources.insert(light.source).second)) continue;
    const bool all_around = !effects.lights[static_cast<std::size_t>(i)].all_around.empty();
    const View caster = all_around
                            ? views_all_around(scene, effects, settings, light).caster
                            : widest_views(measure(scene, effects, light), effects, kCoarseGrid).caster;
    add_shares(paths, light, i, caster, shares);
  }
  return shares;
}

std::vector<LightViews> fit_light_views(const SceneOnDevice& scene, const Effects& effects,
                                        const Settings& settings, const Registry& registry) {
  return LightPilot(scene, registry).fit(effects, settings);
}

float exposure_of(const Scene& scene, const Settings& settings) {
  const glm::vec3 horizon = scene.environment.horizon;
  const double sky = exact::kPi * static_cast<double>(std::max({horizon.x, horizon.y, horizon.z}));
  const double white = std::max(light_level(scene), sky) / exact::kPi;
  double exposure = white > 0.0 ? 0.45 / white : 1.0;
  const double ev = settings.exposure ? static_cast<double>(*settings.exposure) : 0.0;
  // 2^ev by whole steps and a series for the rest.
  double whole = std::floor(ev);
  const double rest = (ev - whole) * 0.69314718055994530942;
  double power = 1.0;
  for (int n = 16; n >= 1; --n) power = 1.0 + power * rest / n;
  for (; whole > 0.5; whole -= 1.0) power *= 2.0;
  for (; whole < -0.5; whole += 1.0) power *= 0.5;
  exposure *= power;
  return static_cast<float>(std::clamp(exposure, 1e-30, 1e30));
}

}  // namespace caustics
