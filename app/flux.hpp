// The flux ledgers of a rendered frame, for the summary and the statistics.
#pragma once
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "app/frame.hpp"
#include "pipeline/measure/landing_images.hpp"
#include "pipeline/measure/model_error.hpp"
#include "pipeline/measure/outcome.hpp"

namespace caustics::app {

struct LightLedger {
  int light = 0;  // index into Scene::sources
  Ledger ledger;
  std::vector<Outcome> outcomes{};  // by caster
  ErrorEstimate error{};
  Surplus surplus{};  // where the model errs; empty where it is not judged

  // The share of the flux onto the casters that leaves the light's maps.
  double leaves() const;
};

// These images, and what can be told of the light on the way to them.
PlanGoal goal_with_ledgers(std::vector<std::string> images);

// Makes the ledgers while the frame is drawn: a light's textures may be gone when the next light's passes
// run.
class LedgerReader {
 public:
  LedgerReader();
  LedgerReader(LedgerReader&&) noexcept;
  LedgerReader& operator=(LedgerReader&&) noexcept;
  ~LedgerReader();

  // To be called after each pass.
  void look(const RenderedFrame& frame, const PlannedPass& pass);
  // The same as a callback; the frame and this must outlive it.
  AfterPass watch(const RenderedFrame& frame);
  // One for each light whose caustic passes ran, in the order of the lights; an area light's is the sum
  // over its samples.
  std::vector<LightLedger> ledgers() const;
  // What looking took; and of processors, what grows with grid and map, and what does not.
  double milliseconds() const { return milliseconds_; }
  double of_texels() const { return of_texels_; }
  double of_rays() const { return of_rays_; }

 private:
  struct Judge;
  ModelError* model_of(const RenderedFrame& frame, int source, int divide);

  std::map<int, LightLedger> by_source_;
  std::unique_ptr<Judge> judge_;  // made at the first look
  double milliseconds_ = 0.0, of_texels_ = 0.0, of_rays_ = 0.0;
};

// The intensity that a source's caustic has, by channel: its samples' sum (caustic_intensity), with those of
// the lights that they stand for.
glm::dvec3 caustic_intensity_of(const RenderedFrame& frame, int source);

// Why no rays are followed to judge the frame's caustics by (ErrorEstimate::judged); empty where they are.
std::string why_not_judged(const RenderedFrame& frame);

// A ledger's accounts with the names that users see, `entered` first.
std::vector<std::pair<const char*, FluxRgb>> accounts(const Ledger& ledger);
double sum(const FluxRgb& flux);

// "'sun'", or "1" where the light has no name; of an index into Scene::sources.
std::string light_label(const Scene& scene, int source);
// "m2 (lumen per lux)" or "sr (lumen per candela)".
const char* flux_unit(const Light& light);
const char* intensity_unit(const Light& light);

}  // namespace caustics::app
