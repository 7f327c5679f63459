#include "app/inspect/vertex_paths.hpp"

#include <cstdlib>
#include <optional>
#include <string>

#include "app/frame.hpp"
#include "app/json.hpp"
#include "app/loaded_scene.hpp"
#include "app/output/light_groups.hpp"
#include "app/probe/probe_texel.hpp"
#include "pipeline/gpu/text.hpp"
#include "pipeline/measure/ledger.hpp"
#include "pipeline/settings/settings.hpp"

namespace caustics::app {

namespace {

// Vertices a side of the lattice: their ways are half of what the rest of a page takes.
constexpr int kLattice = 20;
// Steps of the secant after which it stands still: what all iterates are held against.
constexpr int kConverged = 64;

using Point = std::array<double, 3>;

Point operator+(const Point& a, const Point& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
Point operator*(const Point& a, double by) { return {a[0] * by, a[1] * by, a[2] * by}; }

// Seven digits, as a float has.
double shortened(double value) { return std::strtod(significant(value, 7).c_str(), nullptr); }
Json shortened(const Point& p) { return {shortened(p[0]), shortened(p[1]), shortened(p[2])}; }

// Follows a trace from surface to surface.
class PathReader {
 public:
  void read(const ProbedTexel& texel) {
    for (const NamedValues& v : texel.trace) take(v, {v.values[0], v.values[1], v.values[2]});
  }

  // Errors are those against another way's distances, surface by surface.
  Json path(const std::string& status, const PathReader& truth) const {
    Json iterates = Json::array();
    for (const Iterate& i : iterates_) {
      Json error;
      if (i.surface < truth.ends_.size()) error = shortened(std::abs(i.distance - truth.ends_[i.surface]));
      iterates.push_back({{"label", i.label},
                          {"at", shortened(i.at)},
                          {"distance", shortened(i.distance)},
                          {"error", error}});
    }
    return {{"points", points_}, {"iterates", iterates}, {"status", status}};
  }

 private:
  void take(const NamedValues& v, const Point& p) {
    if (v.name == "entry_point") {
      arrive(p, "entry", "inside");
    } else if (v.name == "exit_point") {
      arrive(p, "exit", "outside");
    } else if (v.name == "surface_point") {
      arrive(p, "surface " + std::to_string(points_.size() + 1), "inside");
    } else if (v.name == "landing_point") {
      // Passes that fly to the receiver say it twice.
      if (points_.empty() || points_.back()["surface"] != "landing") arrive(p, "landing", "outside");
    } else if (v.name == "body" && !points_.empty()) {
      points_.back()["medium"] = p[0] > 0.0 ? "inside" : "outside";
    } else if (v.name == "inside_direction" || v.name == "outside_direction") {
      direction_ = p;
    } else if (v.name == "distance" && start_ && direction_) {
      searched_.push_back(p[0]);
    }
  }

  // The iterates of the search for this point lie on the ray that comes to it.
  void arrive(const Point& p, const std::string& surface, const char* medium) {
    for (std::size_t i = 0; i < searched_.size(); ++i)
      iterates_.push_back({surface + " " + std::to_string(i + 1), ends_.size(),
                           *start_ + *direction_ * searched_[i], searched_[i]});
    ends_.push_back(searched_.empty() ? 0.0 : searched_.back());
    points_.push_back({{"at", shortened(p)}, {"surface", surface}, {"medium", medium}});
    searched_.clear();
    start_ = p;
  }

  struct Iterate {
    std::string label;
    std::size_t surface;  // which of those on the way is searched for
    Point at;
    double distance;
  };

  Json points_ = Json::array();
  std::vector<Iterate> iterates_;
  std::vector<double> ends_;  // where the search for each surface ended
  std::optional<Point> start_, direction_;
  std::vector<double> searched_;
};

// One light's ways by one estimator.
struct Ways {
  std::vector<PathReader> readers{std::size_t{kLattice} * kLattice};
  std::vector<std::string> status{std::size_t{kLattice} * kLattice, "empty"};
};

// Vertices in the middle of equal parts of the grid.
int on_lattice(int i, int grid) { return (2 * i + 1) * grid / (2 * kLattice); }

bool is_on_the_way(const RenderedFrame& frame, const PlannedPass& pass) {
  const bool lands = !pass.definition->writes.empty() && pass.definition->writes.front().name == kLanding;
  return pass.light >= 0 && lands && is_first_sample(frame.scene(), pass.light) &&
         pass.drawn_for->receivers == ReceiverLayer::Nearest;
}

std::map<int, Ways> ways_by(const FrameRequest& request, const std::shared_ptr<LoadedScene>& loaded,
                            std::map<int, int>& grids) {
  RenderedFrame frame(request, loaded, {{kLanding}});
  for (int light = 0; light < static_cast<int>(frame.scene().lights.size()); ++light)
    grids[light] = frame.grid_of(light);
  std::map<int, Ways> ways;
  frame.run([&](const PlannedPass& pass, const PassResult& result, std::size_t, std::size_t) {
    // Of light that parts, the way of the first branch.
    if (!is_on_the_way(frame, pass) || pass.branch != 0 || result.left_out) return true;
    Ways& of_light = ways[pass.light];
    const ProbedPass probe(frame, pass);
    for (int j = 0; j < kLattice; ++j)
      for (int i = 0; i < kLattice; ++i) {
        const ProbedTexel texel =
            probe.at(on_lattice(i, grids[pass.light]), on_lattice(j, grids[pass.light]));
        if (texel.discarded) continue;
        const auto at = static_cast<std::size_t>(j) * kLattice + static_cast<std::size_t>(i);
        of_light.readers[at].read(texel);
        if (!texel.stored.empty() && texel.stored.front().name == kLanding)
          of_light.status[at] = name_of(static_cast<LandingStatus>(texel.stored.front().values[3]));
      }
    return true;
  });
  return ways;
}

}  // namespace

std::map<int, Json> vertex_paths(const FrameRequest& request, const std::shared_ptr<LoadedScene>& loaded) {
  std::map<int, Json> paths;
  std::map<int, int> grids;  // by light
  FrameRequest with = request;
  with.backend.backend = Backend::Software;
  const auto by = [&](const char* estimator, int iterations) {
    set_option(with.settings, "estimator", estimator);
    set_option(with.settings, "iterations", std::to_string(iterations));
    return ways_by(with, loaded, grids);
  };
  std::map<int, Ways> truth = by("secant", kConverged);
  for (const char* estimator : {"secant", "newton", "paper", "impostor"}) {
    for (auto& [light, ways] : by(estimator, request.settings.iterations)) {
      Json& json = paths[light];
      if (json.is_null()) {
        json = {{"vertices", Json::array()}, {"estimators", Json::object()}};
        for (int j = 0; j < kLattice; ++j)
          for (int i = 0; i < kLattice; ++i)
            json["vertices"].push_back({on_lattice(i, grids[light]), on_lattice(j, grids[light])});
      }
      Json& list = json["estimators"][estimator] = Json::array();
      for (std::size_t at = 0; at < ways.readers.size(); ++at)
        list.push_back(ways.readers[at].path(ways.status[at], truth[light].readers[at]));
    }
  }
  return paths;
}

}  // namespace caustics::app
