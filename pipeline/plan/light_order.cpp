#include "pipeline/plan/light_order.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <map>

#include "pipeline/gpu/interrupt.hpp"

namespace caustics {

namespace {

// How a pass uses a texture. An addition comes to the same before and after another light's.
enum class Access : std::uint8_t { Read, Addition, Write };

// The latest phase in which each light's passes, or the frame's (-1), have used a texture, by how.
using Accesses = std::array<std::map<int, int>, 3>;

// Passes are sorted by phase; in a phase those of the frame come first, then light by light.
class Phases {
 public:
  Phases(const FramePlan& plan, SampleOrder order) : order_(order), accesses_(plan.textures.size()) {}

  // The phase of the plan's next pass.
  int of(const PlannedPass& pass) {
    stop_if_interrupted();
    if (order_ == SampleOrder::SampleBySample && pass.sample > sample_) {
      sample_ = pass.sample;
      first_of_sample_ = latest_ + 1;
    }
    int phase = pass.sample > 0 ? first_of_sample_ : 0;
    // A light's passes keep their order among each other.
    if (pass.light >= 0) phase = std::max(phase, light_phases_[pass.light]);
    for_each_use(pass, [&](std::size_t texture, Access use) {
      phase = std::max(phase, earliest(accesses_[texture], pass, use));
    });
    for_each_use(pass, [&](std::size_t texture, Access use) {
      int& latest = accesses_[texture][static_cast<std::size_t>(use)][pass.light];
      latest = std::max(latest, phase);
    });
    if (pass.light >= 0) light_phases_[pass.light] = phase;
    latest_ = std::max(latest_, phase);
    return phase;
  }

 private:
  static int earliest(const Accesses& accesses, const PlannedPass& pass, Access use) {
    int phase = 0;
    for (const Access before : {Access::Read, Access::Addition, Access::Write}) {
      if (before == Access::Read && use == Access::Read) continue;
      const bool additions = before == Access::Addition && use == Access::Addition;
      for (const auto& [light, latest] : accesses[static_cast<std::size_t>(before)]) {
        const bool in_turn = light < 0 || (pass.light >= 0 && light <= pass.light);
        if (in_turn)
          phase = std::max(phase, latest);
        else if (pass.light < 0 || !additions)
          phase = std::max(phase, latest + 1);
      }
    }
    return phase;
  }

  static void for_each_use(const PlannedPass& pass, const auto& visit) {
    for (const int texture : pass.reads)
      if (texture >= 0) visit(static_cast<std::size_t>(texture), Access::Read);
    for (std::size_t a = 0; a < pass.writes.size(); ++a) {
      if (pass.writes[a] < 0) continue;
      const bool adds = pass.keep[a] && pass.definition->writes[a].blend == kAccumulate;
      visit(static_cast<std::size_t>(pass.writes[a]), adds ? Access::Addition : Access::Write);
    }
    if (pass.depth >= 0) visit(static_cast<std::size_t>(pass.depth), Access::Write);
  }

  SampleOrder order_;
  int latest_ = 0, sample_ = 0, first_of_sample_ = 0;  // phases, and the sample that passes are of
  std::vector<Accesses> accesses_;                     // by texture
  std::map<int, int> light_phases_;                    // by light: of its latest pass
};

struct PlaceInOrder {
  int phase, light;
  std::size_t pass;
};

// Samples' passes that read no textures, as of the glass that the camera sees, wait for the first phase that
// uses what they draw.
void wait_for_users(const FramePlan& plan, std::vector<PlaceInOrder>& places) {
  std::map<int, int> used;  // by texture: in which phase for the first time
  for (auto place = places.rbegin(); place != places.rend(); ++place) {
    const PlannedPass& pass = plan.passes[place->pass];
    std::vector<int> textures = pass.attachments();
    const bool reads = std::any_of(pass.reads.begin(), pass.reads.end(), [](int t) { return t >= 0; });
    int first = std::numeric_limits<int>::max();
    for (const int texture : textures)
      if (used.contains(texture)) first = std::min(first, used[texture]);
    if (pass.sample > 0 && !reads && first != std::numeric_limits<int>::max()) place->phase = first;
    textures.insert(textures.end(), pass.reads.begin(), pass.reads.end());
    for (const int texture : textures) {
      int& phase = used.try_emplace(texture, place->phase).first->second;
      phase = std::min(phase, place->phase);
    }
  }
}

}  // namespace

void order_by_light(FramePlan& plan, SampleOrder order) {
  Phases phases(plan, order);
  std::vector<PlaceInOrder> places;
  for (std::size_t i = 0; i < plan.passes.size(); ++i)
    places.push_back({phases.of(plan.passes[i]), plan.passes[i].light, i});
  if (order == SampleOrder::LightByLight) wait_for_users(plan, places);
  std::stable_sort(places.begin(), places.end(), [](const PlaceInOrder& a, const PlaceInOrder& b) {
    return a.phase != b.phase ? a.phase < b.phase : a.light < b.light;
  });
  std::vector<PlannedPass> ordered;
  std::map<int, std::size_t> last;
  for (const PlaceInOrder& place : places) {
    if (plan.passes[place.pass].sample == 0) last[place.light] = ordered.size();
    ordered.push_back(std::move(plan.passes[place.pass]));
  }
  plan.passes = std::move(ordered);
  for (const auto& [light, pass] : last) plan.passes[pass].ends_light = light >= 0;
}

}  // namespace caustics
