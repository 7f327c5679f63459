#include "lab/reference/tracer/tracer.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "pipeline/scene/in_pieces.hpp"

namespace caustics::tracer {

namespace {

// Rays that one piece of work follows, and pieces between two sums in order. Fixed, so that the order of
// all additions is.
constexpr int kRaysPerPiece = 4096, kPiecesAtOnce = 64;

bool shines(const Light& light) {
  return light.intensity > 0.0f && std::max({light.color.x, light.color.y, light.color.z}) > 0.0f;
}

}  // namespace

// What a piece of work hands back.
struct Tracer::Piece {
  std::vector<std::uint32_t> pixels;
  std::vector<glm::dvec3> irradiance;
  Account account;
};

Tracer::Tracer(const Scene& scene, const Effects& effects, const Camera& camera,
               const TraceSettings& settings)
    : settings_(settings),
      world_(scene, effects, settings.exact),
      film_(world_, view_of(camera, settings.width, settings.height, bounds_of(scene)), settings.width,
            settings.height, settings.threads) {
  for (int i = 0; i < static_cast<int>(scene.sources.size()); ++i) {
    if (!world_.throws_caustic(i) || !shines(scene.sources[static_cast<std::size_t>(i)])) continue;
    sources_.push_back(i);
    emissions_.emplace_back(world_, i);
    paths_.emplace_back(world_, i, settings.physics);
  }
  state_.sum.resize(3 * film_.pixels());
  state_.squares.resize(state_.sum.size());
  state_.accounts.resize(scene.sources.size());
}

bool Tracer::trace_light(int source, std::vector<double>& batch, Account& account,
                         const std::function<bool()>& stop) {
  const auto s = static_cast<std::size_t>(source);
  const int light = sources_[s];
  const Light& known = world_.scene().sources[static_cast<std::size_t>(light)];
  const glm::dvec3 intensity = glm::dvec3(known.color) * static_cast<double>(known.intensity);
  const int rays = settings_.side * settings_.side;
  const int pieces = (rays + kRaysPerPiece - 1) / kRaysPerPiece;
  const std::uint64_t stream = mixed(state_.batches * 65536 + static_cast<std::uint64_t>(light));
  for (int first = 0; first < pieces; first += kPiecesAtOnce) {
    if (stop && stop()) return false;
    std::vector<Piece> done(static_cast<std::size_t>(std::min(kPiecesAtOnce, pieces - first)));
    in_pieces(static_cast<int>(done.size()), settings_.threads, [&](int i) {
      Piece& piece = done[static_cast<std::size_t>(i)];
      std::vector<Landing> landings;
      const int from = (first + i) * kRaysPerPiece, to = std::min(from + kRaysPerPiece, rays);
      for (int ray = from; ray < to; ++ray) {
        Numbers numbers(stream, static_cast<std::uint64_t>(ray));
        paths_[s].follow(emissions_[s].ray(ray, settings_.side, static_cast<int>(state_.batches), numbers),
                         numbers, landings, piece.account);
        for (const Landing& landing : landings) {
          std::uint32_t pixel;
          glm::dvec3 irradiance;
          if (!film_.measure(landing, pixel, irradiance)) continue;
          piece.pixels.push_back(pixel);
          piece.irradiance.push_back(irradiance * intensity);
        }
        landings.clear();
      }
    });
    for (const Piece& piece : done) {
      for (std::size_t k = 0; k < piece.pixels.size(); ++k)
        for (std::size_t c = 0; c < 3; ++c)
          batch[3 * std::size_t{piece.pixels[k]} + c] += piece.irradiance[k][static_cast<int>(c)];
      account.add(piece.account);
    }
  }
  return true;
}

bool Tracer::run_batch(const std::function<bool()>& stop) {
  const PlainFloats plain;
  std::vector<double> batch(state_.sum.size(), 0.0);
  std::vector<Account> accounts(state_.accounts.size());
  for (std::size_t s = 0; s < sources_.size(); ++s)
    if (!trace_light(static_cast<int>(s), batch, accounts[static_cast<std::size_t>(sources_[s])], stop))
      return false;
  for (std::size_t i = 0; i < batch.size(); ++i) {
    state_.sum[i] += batch[i];
    state_.squares[i] += batch[i] * batch[i];
  }
  for (std::size_t i = 0; i < accounts.size(); ++i) state_.accounts[i].add(accounts[i]);
  ++state_.batches;
  return true;
}

namespace {

double mean(const TraceState& state, std::size_t i) {
  return state.batches > 0 ? state.sum[i] / static_cast<double>(state.batches) : 0.0;
}

// Of the mean over the batches: sqrt((sum of squares / B - mean^2) / (B - 1)).
double standard_error(const TraceState& state, std::size_t i) {
  if (state.batches < 2) return 0.0;
  const double n = static_cast<double>(state.batches), m = state.sum[i] / n;
  return std::sqrt(std::max(state.squares[i] / n - m * m, 0.0) / (n - 1.0));
}

template <class Value>
std::vector<float> per_value(const TraceState& state, Value value) {
  std::vector<float> result(state.sum.size());
  for (std::size_t i = 0; i < result.size(); ++i) result[i] = static_cast<float>(value(state, i));
  return result;
}

}  // namespace

std::vector<float> Tracer::caustic() const { return per_value(state_, mean); }
std::vector<float> Tracer::caustic_error() const { return per_value(state_, standard_error); }

double Tracer::relative_error() const {
  if (state_.batches < 2) return std::numeric_limits<double>::infinity();
  double errors = 0.0, light = 0.0;
  for (std::size_t i = 0; i < state_.sum.size(); ++i) {
    errors += standard_error(state_, i);
    light += std::fabs(mean(state_, i));
  }
  return light > 0.0 ? errors / light : 0.0;
}

double Tracer::given_up() const {
  glm::dvec3 cut(0.0), landed(0.0);
  for (const Account& account : state_.accounts) {
    cut += account.cut;
    landed += account.landed;
  }
  const double light = (landed.x + landed.y) + landed.z;
  return light > 0.0 ? ((cut.x + cut.y) + cut.z) / light : 0.0;
}

}  // namespace caustics::tracer
