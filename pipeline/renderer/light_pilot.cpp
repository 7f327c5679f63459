#include "pipeline/renderer/light_pilot.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <memory>
#include <optional>

#include "pipeline/effects/branches.hpp"
#include "pipeline/effects/cascades.hpp"
#include "pipeline/effects/dim_lights.hpp"
#include "pipeline/gpu/device.hpp"
#include "pipeline/measure/ledger.hpp"
#include "pipeline/measure/light_paths.hpp"
#include "pipeline/plan/frame_plan.hpp"
#include "pipeline/renderer/lit_receivers.hpp"
#include "pipeline/renderer/pilot_rays.hpp"
#include "pipeline/renderer/run_plan.hpp"
#include "pipeline/renderer/widest_views.hpp"
#include "pipeline/scene/defaults.hpp"
#include "pipeline/scene/environment.hpp"
#include "pipeline/scene/exact.hpp"
#include "pipeline/settings/settings.hpp"
#include "pipeline/settings/splat_kernel.hpp"
#include "pipeline/views/cascades.hpp"
#include "pipeline/views/landing_window.hpp"

namespace caustics {

namespace {

// Of the share that may fall outside of a map, where the map has a cascade.
constexpr double kCascadedShare = 0.25;
// A cascade's window is wider than its light by this share; covering_texels adds the border that is not
// looked up.
constexpr double kCascadeMargin = 0.03;
// What a window is widened by for its splats at most: a map of few texels is no kernel's width. Beyond, the
// ledger's kernel_edge has it.
constexpr double kWidestMargin = 1.0;
// Less of its light may land where a light's view of its casters does not show it.
constexpr double kBeyond = 0.1;
// The coarse run that looks for landings.
constexpr int kCoarseGrid = 96, kCoarseMap = 256, kCoarseIterations = 8;

// A light's, of all branches.
struct FoundLandings {
  std::vector<WeightedPoint> points{};
  double hidden = 0.0;  // weight of those that only the map of the farthest receivers shows

  // Is more than a tenth?
  bool is_hidden() const {
    double sum = 0.0;
    for (const WeightedPoint& point : points) sum += point.weight;
    return hidden > 0.1 * sum;
  }
};

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

// Light that is followed to where its light does not see it has landed all the same: it is shown by the map
// of the farthest receivers. Returns how much of it there is.
double take_hidden_for_landed(Image& landing, const Image& flux) {
  double hidden = 0.0;
  for (int y = 0; y < landing.height(); ++y)
    for (int x = 0; x < landing.width(); ++x) {
      float& status = landing.at(x, y, 3);
      if (status != static_cast<float>(LandingStatus::NotConverged)) continue;
      status = static_cast<float>(LandingStatus::Landed);
      hidden += static_cast<double>(std::max({flux.at(x, y, 0), flux.at(x, y, 1), flux.at(x, y, 2)}));
    }
  return hidden;
}

// Draws the caustic view in to the landings, and the receiver view to them and the casters.
void fit_to_landings(LightViews& views, const FoundLandings& found, const Settings& settings, double margin,
                     const Effects& effects) {
  const std::vector<WeightedPoint>& points = found.points;
  views.cascade.reset();
  if (points.empty()) return;
  const LandedFlux landed(points);
  const double shortest = landed.shortest_side(settings.map);
  set_window(views.caustic, landed.window(0.25 * settings.outside_share), margin, shortest);
  // Light that is spread has no bright part to be shown finer, and the farthest receivers have no cascade.
  if (can_have_cascades(settings) && !all_light_is_spread(effects) && !found.is_hidden())
    views.cascade = cascade_view(views.caustic, landed, kCascadeMargin, shortest);
  // Where a cascade shows the bright part, the map around it can be wider and lose less; but the receiver map
  // would have to be as wide, and on receivers that are not flat its texels tell where light lands.
  if (views.cascade && effects.receivers_are_one_plane)
    set_window(views.caustic, landed.window(0.25 * kCascadedShare * settings.outside_share), margin,
               shortest);
  if (views.cascade) views.cascade = covering_texels(*views.cascade, views.caustic, settings);
  const bool apart = views.caustic.forward != views.caster.forward;
  views.receiver.window_lower =
      apart ? views.caustic.window_lower : glm::min(views.caustic.window_lower, views.caster.window_lower);
  views.receiver.window_upper =
      apart ? views.caustic.window_upper : glm::max(views.caustic.window_upper, views.caster.window_upper);
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
  void show(int light, const std::function<void(Image landing, const Image& flux)>& to) const {
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

// From where a light sees its casters, and the picture its light; no camera: null.
struct PilotViews {
  const LightViews& light;
  const View* camera;
};

// Would its widest window show a point?
bool shows(const View& view, const glm::dvec3& p) {
  const glm::dvec3 q = view.coordinates(p);
  return std::max(std::fabs(q.x), std::fabs(q.y)) <= kWidestTangent * q.z;
}

// Of the light that lands, what share such a view does not show.
double share_beyond(const View& view, const std::vector<LightLanding>& landings) {
  double whole = 0.0, beyond = 0.0;
  for (const LightLanding& landing : landings) {
    whole += flux_of(landing);
    if (!shows(view, landing.position)) beyond += flux_of(landing);
  }
  return whole > 0.0 ? beyond / whole : 0.0;
}

// Which way a light looks that shows more of where its light lands than the view of its casters does; 0: that
// view shows it. Only light with a place can be sent where it does not look.
glm::dvec3 way_to_landings(const Light& light, const View& caster,
                           const std::vector<LightLanding>& landings) {
  if (light.type == LightType::Directional || caster.cube) return glm::dvec3(0.0);
  const double beyond = share_beyond(caster, landings);
  if (beyond < kBeyond) return glm::dvec3(0.0);
  glm::dvec3 sum(0.0);
  for (const LightLanding& landing : landings)
    sum += exact::normalise(landing.position - light.position, glm::dvec3(0.0)) * flux_of(landing);
  const glm::dvec3 way = exact::normalise(sum, caster.forward);
  View turned = view_along(light.position, way);
  turned.perspective = true;
  return share_beyond(turned, landings) < 0.5 * beyond ? way : glm::dvec3(0.0);
}

// How much of the picture an area at a point fills, up to a factor: nothing where it is not seen directly.
double size_in_picture(const LightPaths& paths, const View* camera, const glm::dvec3& p) {
  if (!camera) return 0.0;
  const glm::dvec3 q = camera->coordinates(p), way = camera->origin - p;
  if (!(q.z > 0.0)) return 0.0;
  const glm::dvec2 at = camera->window(q);
  if (glm::any(glm::lessThan(at, camera->window_lower)) ||
      glm::any(glm::greaterThan(at, camera->window_upper)))
    return 0.0;
  const bool blocked = camera->perspective ? paths.casters_block(p, exact::normalise(way, -camera->forward),
                                                                 exact::length(way))
                                           : paths.casters_block(p, -camera->forward, q.z);
  return blocked ? 0.0 : camera->perspective ? 1.0 / (q.z * q.z) : 1.0;
}

void add_shares(const LightPaths& paths, const RayTables& tables, const Light& light, int number,
                const PilotViews& views, int step, std::vector<FurtherShare>& shares) {
  const View& caster = views.light.caster;
  struct Landed {
    double all = 0.0, simple = 0.0;  // on the ways that the passes take which know two surfaces
  };
  std::map<int, Landed> landed;
  double whole = 0.0;
  std::vector<LightLanding> landings, astray;
  paths.follow(pilot_rays(light, caster, step), landings, 0.0, &astray);
  for (const LightLanding& other : astray) {
    landed[other.first].all += flux_of(other);
    whole += flux_of(other);
  }
  const glm::dvec3 looks = way_to_landings(light, caster, landings);
  const std::vector<LandingSeen> seen = seen_by_light({paths, tables, light, views.light}, landings);
  const LitReceivers lit = lit_receivers(landings, seen, tables.scene().meshes.size());
  double shown = 0.0, shown_simply = 0.0;
  for (std::size_t i = 0; i < landings.size(); ++i) {
    const LightLanding& landing = landings[i];
    const double flux = flux_of(landing);
    Landed& sum = landed[landing.first];
    sum.all += flux;
    const double in_picture = flux * size_in_picture(paths, views.camera, landing.position);
    shown += in_picture;
    // What the light's own view of its receivers does not show, its maps cannot find.
    const bool found =
        (looks == glm::dvec3(0.0) || shows(caster, landing.position)) && !seen[i].hidden && !seen[i].behind;
    if (landing.followed && found) {
      sum.simple += flux;
      shown_simply += in_picture;
    }
    whole += flux;
  }
  for (const auto& [mesh, sum] : landed)
    if (sum.all > 0.0)
      shares.push_back({.light = number,
                        .mesh = mesh,
                        .share = 1.0 - sum.simple / sum.all,
                        .of_light = sum.all / whole,
                        .seen = shown > 0.0 ? 1.0 - shown_simply / shown : 0.0,
                        .looks = looks,
                        .lit = lit});
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
  const LightSettings own(settings, effects);
  for (const bool is_last : {false, true})
    scout.run(views, [&](int i) {
      if (!fitted(i)) return;
      const auto light = static_cast<std::size_t>(i);
      const double margin = is_last ? std::min(0.03 + 2.0 * kernel_texels / own[i].map, kWidestMargin) : 0.5;
      FoundLandings found;
      LandingSurvey survey;
      scout.show(i, [&](Image landing, const Image& flux) {
        if (effects.further_surfaces.active) found.hidden += take_hidden_for_landed(landing, flux);
        add_landings(landing, flux, views[light].caustic, found.points);
        if (surveys) survey.add(survey_landings(landing, flux, views[light].caustic));
      });
      fit_to_landings(views[light], found, own[i], margin, effects);
      if (surveys) (*surveys)[light] = std::move(survey);
    });
}

std::vector<LightViews> LightPilot::fit(const Effects& effects, const Settings& settings,
                                        std::vector<LandingSurvey>* surveys) {
  std::vector<LightViews> views;
  views.reserve(scene_.scene().lights.size());
  const LightSettings own(settings, effects);
  for (int i = 0; i < static_cast<int>(scene_.scene().lights.size()); ++i)
    views.push_back(widest_views(scene_.scene(), effects, own[i], i));
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

std::vector<FurtherShare> LightPilot::further_shares(const Effects& effects, const Settings& settings,
                                                     const View* camera) const {
  const Scene& scene = scene_.scene();
  const LightPaths paths(scene_.tables(), effects, settings, registry_);
  std::vector<FurtherShare> shares;
  Settings coarse = settings;
  coarse.grid = kCoarseGrid;
  const std::vector<int> lights = lights_to_pilot(scene, effects);
  for (const int i : lights) {
    const auto index = static_cast<std::size_t>(i);
    const bool all_around = !effects.lights[index].all_around.empty();
    const LightViews views = widest_views(scene, effects, all_around ? settings : coarse, i);
    add_shares(paths, scene_.tables(), scene.lights[index], i, {views, camera}, pilot_step(lights.size()),
               shares);
  }
  return shares;
}

std::vector<LightViews> fit_light_views(const SceneOnDevice& scene, const Effects& effects,
                                        const Settings& settings, const Registry& registry) {
  return LightPilot(scene, registry).fit(effects, settings);
}

}  // namespace caustics
