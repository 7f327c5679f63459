#include "app/flux.hpp"

#include "app/output/light_groups.hpp"
#include "app/shell/progress.hpp"
#include "app/shell/terminal.hpp"
#include "pipeline/effects/dim_lights.hpp"
#include "pipeline/effects/drawn_sizes.hpp"
#include "pipeline/gpu/device.hpp"
#include "pipeline/measure/drawn_points.hpp"
#include "pipeline/measure/pixel_side.hpp"
#include "pipeline/measure/unseen_casters.hpp"
#include "pipeline/scene/in_pieces.hpp"
#include "pipeline/settings/settings.hpp"

namespace caustics::app {

namespace {
// The statement is of means over squares of so many pixels a side.
constexpr double kJudgedPixels = 4.0;
// Followed through the scene for each light; fewer for one that adds little (LightEffects::divide).
constexpr int kRaysOfJudge = 8192;
}  // namespace

PlanGoal goal_with_ledgers(std::vector<std::string> images) {
  PlanGoal goal{.textures = std::move(images), .beside = ledger_textures(), .light_by_light = true};
  goal.beside.emplace_back("beauty");
  return goal;
}

namespace {

// The casters in the order of their rows in kCasterMaterials. None where casters share rows.
std::vector<int> casters_by_row(const RenderedFrame& frame) {
  std::vector<int> meshes;
  for (int m = 0; m < static_cast<int>(frame.effects().surfaces.size()); ++m) {
    if (!is_caster(frame.effects().surfaces[static_cast<std::size_t>(m)].role)) continue;
    if (frame.on_device().tables().material_row(m) != static_cast<int>(meshes.size())) return {};
    meshes.push_back(m);
  }
  return meshes;
}

// What a light's sample wrote besides its branches', as it is until the next pass.
struct SampleMaps {
  ImageView map, far_map, cascade, caster_normal, caster_position, view_position;
};

SampleMaps maps_of(const RenderedFrame& frame, int light) {
  const auto read = [&](const std::string& name) { return frame.look_at(name); };
  const bool drawn = frame.effects().lights[static_cast<std::size_t>(light)].size_is_drawn;
  const auto if_any = [&](const std::string& name) { return frame.has(name) ? read(name) : ImageView{}; };
  return {.map = read(light_texture(kCausticMap, light)),
          .far_map = if_any(light_texture(far_texture(kCausticMap), light)),
          .cascade = if_any(light_texture(kCascadeMap, light)),
          .caster_normal = read(light_texture(kCasterNormal, light)),
          .caster_position = drawn ? read(light_texture(kCasterPosition, light)) : ImageView{},
          .view_position = frame.settings().pixel_means ? if_any(kViewPosition) : ImageView{}};
}

void run_side_by_side(std::initializer_list<std::function<void()>> parts) {
  in_pieces(static_cast<int>(parts.size()), 0, [&](int part) { parts.begin()[part](); });
}

void add_outcomes(const std::vector<Outcome>& outcomes, double share, std::vector<Outcome>& sum) {
  if (sum.empty())
    for (const Outcome& outcome : outcomes) sum.push_back({.mesh = outcome.mesh});
  for (std::size_t i = 0; i < outcomes.size(); ++i) add(sum[i], outcomes[i], share);
}

// Returns the points of the light of which this one is a sample, if the size of that is drawn.
std::optional<DrawnPoints> points_of(const RenderedFrame& frame, int light) {
  const auto index = static_cast<std::size_t>(light);
  if (!frame.effects().lights[index].size_is_drawn) return {};
  const auto source = static_cast<std::size_t>(frame.scene().lights[index].source);
  return DrawnPoints(frame.scene(), frame.scene().sources[source]);
}

double unseen_of(const RenderedFrame& frame, int light, const LightPaths& paths, const DrawnPoints& points) {
  if (!points.has_place()) return 0.0;
  return unseen_share(frame.scene(), casters_of(frame.effects(), light), paths, points,
                      frame.scene().lights[static_cast<std::size_t>(light)].position);
}

// Adds what a light's sample did, `share` times. What does not wait for one another goes side by side.
// Returns the processor milliseconds of rays.
double add_sample(const RenderedFrame& frame, int light, double share, LightLedger& sum, ModelError* model) {
  const SampleMaps maps = maps_of(frame, light);
  const LightViews& views = frame.views()[static_cast<std::size_t>(light)];
  const std::vector<int> casters = casters_by_row(frame);
  const LightSettings own(frame.settings(), frame.effects());
  const Settings& settings = own[light];
  LedgerSum ledger_sum(views.caustic, settings, maps.map.width());
  ErrorSum error_sum(views, settings, maps.map.width(), !maps.cascade.values.empty());
  std::vector<BranchImages> judged;  // the model looks at all branches at once
  for (Branch branch : frame.effects().branches) {
    branch.spread = branch.spread || frame.effects().lights[static_cast<std::size_t>(light)].size_is_drawn;
    const auto has = [&](const std::string& name) { return frame.has(name); };
    const auto read = [&](const std::string& name) { return frame.look_at(name); };
    const BranchImages images = images_of_branch(light, branch, has, read);
    const CellImages cells = cells_of_branch(light, branch, has, read);
    run_side_by_side(
        {[&] { ledger_sum.add(images, cells); }, [&] { error_sum.add(images, cells); },
         [&] { add_outcomes(outcomes_of({images}, maps.caster_normal, casters), share, sum.outcomes); }});
    // Only what it looks at: some devices have made copies.
    if (model) judged.push_back({branch, images.landing, images.flux, images.fresnel, {}, {}, {}, {}});
  }
  Ledger ledger;
  double pixel = 0.0;
  const std::optional<DrawnPoints> points = model ? points_of(frame, light) : std::nullopt;
  const Stopwatch rays;
  run_side_by_side(
      {[&] {
         if (model)
           model->add({.light = frame.scene().lights[static_cast<std::size_t>(light)],
                       .caster = views.caster,
                       .branches = judged,
                       .share = share,
                       .samples = maps.caster_position.values.empty()
                                      ? static_cast<int>(samples_of(frame.scene(), sum.light).size())
                                      : 1,
                       .points = points ? &*points : nullptr,
                       .caster_position = maps.caster_position,
                       .unseen = points ? unseen_of(frame, light, model->paths(), *points) : 0.0});
       },
       [&] { ledger = ledger_sum.with_maps(maps.map, maps.far_map); },
       [&] {
         pixel = kJudgedPixels * pixel_side(maps.view_position, maps.map, views.caustic,
                                            frame.effects().lights[static_cast<std::size_t>(light)].divide);
       }});
  const double of_rays = rays.processor_milliseconds();
  add(sum.ledger, ledger, share);
  add(sum.error, error_sum.with_maps(maps.map, maps.cascade, ledger, pixel), share);
  return of_rays;
}

}  // namespace

std::string why_not_judged(const RenderedFrame& frame) {
  if (!frame.has(kViewPosition)) return "the picture has no view of the caustics";
  if (frame.settings().weights == Weights::Paper) return "the paper's weights are not those of light";
  if (frame.effects().water_waves.active && !frame.on_pilot().tables().meets_waters())
    return "the waves are in no hierarchy, since their light is not followed";
  return {};
}

double LightLedger::leaves() const {
  const double entered = sum(ledger.entered);
  return entered > 0.0 ? (sum(ledger.outside) + sum(ledger.kernel_edge)) / entered : 0.0;
}

// What a frame's light is judged by, beside the frame itself. It looks at the picture's surfaces where
// the frame has them: its lights are judged before it is drawn again.
struct LedgerReader::Judge {
  LightPaths paths;
  PictureBlocks blocks;
  std::map<int, ModelError> models{};  // by source
  explicit Judge(const RenderedFrame& frame)
      : paths(frame.on_pilot().tables(), frame.effects(), frame.settings(), frame.registry()),
        blocks(frame.look_at(kViewPosition), frame.inputs().camera) {}
};

LedgerReader::LedgerReader() = default;
LedgerReader::LedgerReader(LedgerReader&&) noexcept = default;
LedgerReader& LedgerReader::operator=(LedgerReader&&) noexcept = default;
LedgerReader::~LedgerReader() = default;

ModelError* LedgerReader::model_of(const RenderedFrame& frame, int source, int divide) {
  if (!judge_) {
    if (!why_not_judged(frame).empty()) return nullptr;
    judge_ = std::make_unique<Judge>(frame);
  }
  return &judge_->models.try_emplace(source, judge_->paths, judge_->blocks, kRaysOfJudge / (divide * divide))
              .first->second;
}

void LedgerReader::look(const RenderedFrame& frame, const PlannedPass& pass) {
  if (!pass.ends_light) return;
  const Branch& branch = frame.effects().branches.front();
  if (!frame.has(branch_texture(kLanding, pass.light, branch))) return;
  if (!frame.has(light_texture(kCausticMap, pass.light))) return;
  frame.device().finish();
  const Stopwatch watch;
  const Light& light = frame.scene().lights[static_cast<std::size_t>(pass.light)];
  const Light& source = frame.scene().sources[static_cast<std::size_t>(light.source)];
  LightLedger& sum =
      by_source_.try_emplace(light.source, LightLedger{.light = light.source, .ledger = {}}).first->second;
  // A sample's flux is relative to its own intensity.
  const bool whole = frame.effects().lights[static_cast<std::size_t>(pass.light)].size_is_drawn;
  const double share =
      whole ? 1.0 : static_cast<double>(light.intensity) / static_cast<double>(source.intensity);
  const double of_rays = add_sample(
      frame, pass.light, share, sum,
      model_of(frame, light.source, frame.effects().lights[static_cast<std::size_t>(pass.light)].divide));
  milliseconds_ += watch.milliseconds();
  of_rays_ += of_rays;
  of_texels_ += watch.processor_milliseconds() - of_rays;
}

AfterPass LedgerReader::watch(const RenderedFrame& frame) {
  return [this, &frame](const PlannedPass& pass, const PassResult&, std::size_t, std::size_t) {
    look(frame, pass);
    return true;
  };
}

std::vector<LightLedger> LedgerReader::ledgers() const {
  std::vector<LightLedger> all;
  for (const auto& [source, ledger] : by_source_) {
    all.push_back(ledger);
    if (!judge_ || !judge_->models.contains(source)) continue;
    judge_->models.at(source).complete(all.back().error);
    all.back().surplus = judge_->models.at(source).surplus();
  }
  return all;
}

glm::dvec3 caustic_intensity_of(const RenderedFrame& frame, int source) {
  const Light& light = frame.scene().sources[static_cast<std::size_t>(source)];
  glm::dvec3 intensity = static_cast<double>(light.intensity) * glm::dvec3(light.color);
  for (std::size_t l = 0; l < frame.scene().lights.size(); ++l) {
    if (frame.scene().lights[l].source != source) continue;
    const LightEffects& effects = frame.effects().lights[l];
    if (effects.size_is_drawn) return glm::dvec3(caustic_intensity(frame.scene().lights[l], effects));
    intensity += glm::dvec3(effects.of_others);
  }
  return intensity;
}

std::vector<std::pair<const char*, FluxRgb>> accounts(const Ledger& ledger) {
  return {{"entered", ledger.entered},
          {"in_map", ledger.in_map},
          {"fresnel", ledger.fresnel},
          {"absorbed", ledger.absorbed},
          {"total_reflection", ledger.total_reflection},
          {"medium", ledger.medium},
          {"missed", ledger.missed},
          {"outside", ledger.outside},
          {"not_converged", ledger.not_converged},
          {"exit_not_found", ledger.exit_not_found},
          {"given_up", ledger.given_up},
          {"kernel_edge", ledger.kernel_edge}};
}

double sum(const FluxRgb& flux) { return flux[0] + flux[1] + flux[2]; }

std::string light_label(const Scene& scene, int source) {
  const std::string& name = scene.sources[static_cast<std::size_t>(source)].name;
  return name.empty() ? std::to_string(source) : "'" + one_line(name) + "'";
}

const char* flux_unit(const Light& light) {
  return light.type == LightType::Directional ? "m2 (lumen per lux)" : "sr (lumen per candela)";
}

const char* intensity_unit(const Light& light) { return light.type == LightType::Directional ? "lx" : "cd"; }

}  // namespace caustics::app
