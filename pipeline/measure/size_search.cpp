#include "pipeline/measure/size_search.hpp"

#include <algorithm>

namespace caustics {

namespace {

// Sizes of grid and maps that are chosen from.
constexpr int kTriedSides[] = {64, 96, 128, 192, 256, 384, 512, 768, 1024, 1536, 2048};
constexpr std::size_t kMostTrials = 8;
// Room for what a cost model gets wrong, until something has met the demand.
constexpr double kMargin = 0.85;
// What is gained must be more than this share to be worth a trial.
constexpr double kWorthTrying = 0.1;
// How many times longer than the last one a trial may be expected to take: a cost model is not to be trusted
// far from what it was measured at.
constexpr double kFarther = 8.0;
// And how many times larger either side may be than the largest that was tried, or than what a cost model has
// seen of it: noise can hide what a side costs.
constexpr int kLarger = 4, kSeen = 256;
// Of the model's error: less of the sizes' would not show beside it.
constexpr double kBesideModel = 0.25;

}  // namespace

SizeSearch::SizeSearch(const CostModel& model, const Demand& demand) : model_(model), demand_(demand) {}

bool SizeSearch::only_model() const {
  return demand_.error && model_.expect(kTriedSides[0], kTriedSides[0]).model >= *demand_.error;
}

double SizeSearch::bound() const {
  if (!demand_.error) return demand_.milliseconds.value_or(std::numeric_limits<double>::infinity());
  const double of_model = model_.expect(kTriedSides[0], kTriedSides[0]).model;
  return only_model() ? std::max(*demand_.error, kBesideModel * of_model) : *demand_.error - of_model;
}

// What the model errs more in a trial than with the finest grid, which the bound leaves out, counts as of its
// sizes.
SizeSearch::Candidate SizeSearch::candidate(const Trial& trial) const {
  const double of_model = trial.model - model_.expect(trial.grid, trial.map).model;
  return demand_.error
             ? Candidate{trial, trial.of_sizes() + (only_model() ? 0.0 : of_model), trial.milliseconds}
             : Candidate{trial, trial.milliseconds, trial.of_sizes()};
}

// Finer sizes err less and take longer: what is coarser than sizes that err too much, or finer than sizes
// that take too long, need not be tried.
bool SizeSearch::is_ruled_out(int grid, int map) const {
  int largest_grid = kSeen, largest_map = kSeen;
  for (const Trial& trial : trials_) {
    largest_grid = std::max(largest_grid, trial.grid);
    largest_map = std::max(largest_map, trial.map);
  }
  if (grid > kLarger * largest_grid || map > kLarger * largest_map) return true;
  return std::any_of(trials_.begin(), trials_.end(), [&](const Trial& trial) {
    if (trial.grid == grid && trial.map == map) return true;
    if (is_met(trial)) return false;
    return demand_.error ? grid <= trial.grid && map <= trial.map : grid >= trial.grid && map >= trial.map;
  });
}

std::optional<Trial> SizeSearch::better_than(const Trial& best) const {
  std::optional<Candidate> found;
  for (const int grid : kTriedSides)
    for (const int map : kTriedSides) {
      const Candidate c = candidate(model_.expect(grid, map));
      if (c.demanded > bound() || is_ruled_out(grid, map)) continue;
      if (c.wanted > (1.0 - kWorthTrying) * candidate(best).wanted) continue;
      if (!found || c.wanted < found->wanted) found = c;
    }
  return found ? std::optional(found->expected) : std::nullopt;
}

std::optional<Trial> SizeSearch::first_to_meet(double longest) const {
  std::optional<Candidate> best, closest;
  double least = std::numeric_limits<double>::infinity();
  for (const int grid : kTriedSides)
    for (const int map : kTriedSides) {
      const Candidate c = candidate(model_.expect(grid, map));
      if (c.expected.milliseconds > longest || is_ruled_out(grid, map)) continue;
      least = std::min(least, c.demanded);
      if (c.demanded <= kMargin * bound() && (!best || c.wanted < best->wanted)) best = c;
    }
  if (best) return best->expected;
  // Nothing is expected to meet it: of what comes about as close as anything, the best.
  for (const int grid : kTriedSides)
    for (const int map : kTriedSides) {
      const Candidate c = candidate(model_.expect(grid, map));
      if (c.expected.milliseconds > longest || is_ruled_out(grid, map)) continue;
      if (c.demanded <= (1.0 + kWorthTrying) * least && (!closest || c.wanted < closest->wanted)) closest = c;
    }
  return closest ? std::optional(closest->expected) : std::nullopt;
}

std::optional<Trial> SizeSearch::next() const {
  if (trials_.size() >= kMostTrials) return {};
  if (trials_.empty())
    return first_to_meet(kFarther * model_.expect(2 * kTriedSides[2], kTriedSides[2]).milliseconds);
  const std::optional<Trial> best = chosen();
  if (is_met(*best)) return better_than(*best);
  const std::optional<Trial> trial = first_to_meet(kFarther * trials_.back().milliseconds);
  if (!trial || candidate(*trial).demanded <= bound()) return trial;
  // Not worth its time where hardly anything is gained by it, of the whole error.
  const auto missed_by = [&](const Trial& t) { return demand_.error ? t.error() : t.milliseconds; };
  return missed_by(*trial) <= (1.0 - kWorthTrying) * missed_by(*best) ? trial : std::nullopt;
}

void SizeSearch::learn(const Trial& found) {
  trials_.push_back(found);
  model_.learn(found);
}

std::optional<Trial> SizeSearch::chosen() const {
  std::optional<Candidate> best;
  for (const Trial& trial : trials_) {
    const Candidate c = candidate(trial);
    if (!best) {
      best = c;
    } else if (is_met(trial) != is_met(best->expected)) {
      if (is_met(trial)) best = c;
    } else if (is_met(trial) ? c.wanted < best->wanted : c.demanded < best->demanded) {
      best = c;
    }
  }
  return best ? std::optional(best->expected) : std::nullopt;
}

}  // namespace caustics
