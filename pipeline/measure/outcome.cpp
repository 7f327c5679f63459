#include "pipeline/measure/outcome.hpp"

#include <algorithm>

namespace caustics {

namespace {

// Less than this share is no caustic that anyone would see.
constexpr double kLeastShare = 1e-3;

double mean(const ImageView& image, int x, int y) {
  return (double(image.at(x, y, 0)) + double(image.at(x, y, 1)) + double(image.at(x, y, 2))) / 3.0;
}

std::string reason_of(LandingStatus status, bool over_added_ground) {
  switch (status) {
    case LandingStatus::TotalReflection:
      return "all of its light is totally reflected inside; --sun lights it from another side";
    case LandingStatus::Missed:
    case LandingStatus::Outside:
      return std::string("all of its light goes past everything that could show it") +
             (over_added_ground ? ", the added ground too; --sun moves the light"
                                : "; --ground on puts a ground below, --sun moves the light");
    case LandingStatus::Absorbed:
      return "its material absorbs all of the light";
    case LandingStatus::NotConverged:
      return "none of its light could be followed to the end";
    case LandingStatus::ExitNotFound:
      return "where its light leaves it was not found: behind a nearer second surface, perhaps";
    case LandingStatus::GivenUp:
      return "all of its light is given up on its way through the casters";
    case LandingStatus::Empty:
    case LandingStatus::Landed:
    case LandingStatus::Stopped:
      break;
  }
  return "hardly any of its light is left";
}

}  // namespace

std::vector<Outcome> outcomes_of(const std::vector<BranchImages>& branches, const ImageView& caster_normal,
                                 const std::vector<int>& mesh_of_row) {
  std::vector<Outcome> outcomes;
  outcomes.reserve(mesh_of_row.size());
  for (const int mesh : mesh_of_row) outcomes.push_back({.mesh = mesh});
  for (const BranchImages& images : branches) {
    const glm::vec3& color = images.branch.color;
    const double weight = (double(color.x) + double(color.y) + double(color.z)) / 3.0;
    for (int y = 0; y < images.landing.height(); ++y) {
      for (int x = 0; x < images.landing.width(); ++x) {
        const auto status = static_cast<std::size_t>(images.landing.at(x, y, 3));
        const auto row = static_cast<std::size_t>(caster_normal.at(x, y, 3));
        if (status == static_cast<std::size_t>(LandingStatus::Empty) || row >= outcomes.size()) continue;
        Outcome& outcome = outcomes[row];
        // What was mirrored has entered with the light that was let in.
        if (!images.branch.reflected) outcome.entered += weight * double(images.fresnel.at(x, y, 3));
        outcome.ended[status] += mean(images.flux, x, y);
      }
    }
  }
  return outcomes;
}

void add(Outcome& sum, const Outcome& other, double share) {
  sum.entered += other.entered * share;
  for (std::size_t s = 0; s < sum.ended.size(); ++s) sum.ended[s] += other.ended[s] * share;
}

std::string why_no_caustic(const Outcome& outcome, bool over_added_ground) {
  if (!(outcome.entered > 0.0)) return kNoLightReachesIt;
  if (outcome.share(LandingStatus::Landed) >= kLeastShare) return {};
  const auto most = std::max_element(outcome.ended.begin(), outcome.ended.end()) - outcome.ended.begin();
  const bool is_most =
      *std::max_element(outcome.ended.begin(), outcome.ended.end()) > kLeastShare * outcome.entered;
  return reason_of(is_most ? static_cast<LandingStatus>(most) : LandingStatus::Landed, over_added_ground);
}

}  // namespace caustics
