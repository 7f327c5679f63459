// The forward light tracer: a picture of the caustics of a scene as light itself would draw it, by rays from
// the lights through the casters onto what the camera sees. docs/reference.md says what it simulates.
//
// Progressive: each batch is one stratified set of rays by itself, so that their spread tells the error.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "lab/reference/tracer/film.hpp"
#include "lab/reference/tracer/paths.hpp"
#include "pipeline/effects/effects.hpp"

namespace caustics::tracer {

struct TraceSettings {
  int width = 1280, height = 720;  // picture
  int side = 512;                  // side^2 rays for each light and batch; 1..16384
  Physics physics = Physics::Single;
  int threads = 0;                     // 0: one a core; changes no bit
  std::vector<ExactShape> exact = {};  // traced in place of their meshes
};

// Everything that batches add up to; what a state file keeps.
struct TraceState {
  std::uint64_t batches = 0;
  std::vector<double> sum, squares;  // of the batches' irradiance, lux; three a pixel, rows from the bottom
  std::vector<Account> accounts;     // by Scene::sources
};

class Tracer {
 public:
  // `camera` and both others must outlive the tracer; sample_lights has run on the scene. Throws Error:
  // BadInput for what is not simulated, BackendUnavailable in a build without Embree.
  Tracer(const Scene& scene, const Effects& effects, const Camera& camera, const TraceSettings& settings);
  Tracer(const Tracer&) = delete;
  Tracer& operator=(const Tracer&) = delete;

  // One more batch. `stop` is asked between pieces of it; where it says so the batch is dropped and false
  // returned.
  bool run_batch(const std::function<bool()>& stop = {});

  const TraceState& state() const { return state_; }
  void restore(TraceState state) { state_ = std::move(state); }

  int lights() const { return static_cast<int>(sources_.size()); }  // that throw caustics
  const Film& film() const { return film_; }
  const World& world() const { return world_; }
  // Lux, three a pixel: the mean of the batches, and its standard error (0 before the second batch).
  std::vector<float> caustic() const;
  std::vector<float> caustic_error() const;
  // Sum of the standard errors over the sum of the irradiance, all pixels and channels; infinite before
  // the second batch, 0 where nothing is lit.
  double relative_error() const;
  // The part of the error that more rays do not take away: light given up on its way (Account::cut), over
  // what landed.
  double given_up() const;

 private:
  struct Piece;
  bool trace_light(int source, std::vector<double>& batch, Account& account,
                   const std::function<bool()>& stop);

  TraceSettings settings_;
  World world_;
  Film film_;
  std::vector<Emission> emissions_;  // of the lights that throw caustics
  std::vector<Paths> paths_;
  std::vector<int> sources_;
  TraceState state_;
};

}  // namespace caustics::tracer
