// The closing lines of `caustics reference`, and its statistics.
#pragma once
#include <string>
#include <utility>
#include <vector>

#include "app/reference_options.hpp"

namespace caustics::app {

struct ReferenceTiming {
  double prepare = 0.0, trace = 0.0, total = 0.0;  // milliseconds
  std::uint64_t batches = 0;                       // of this run, those resumed from left out
};

// An account by the names that users see, `entered` first.
std::vector<std::pair<const char*, glm::dvec3>> accounts(const tracer::Account& account);

void print_reference(const ReferenceRequest& request, const Scene& scene, const Effects& effects,
                     const tracer::Tracer& tracer, const ReferenceTiming& timing);
std::string reference_stats(const ReferenceRequest& request, const Scene& scene, const tracer::Tracer& tracer,
                            const ReferenceTiming& timing);

}  // namespace caustics::app
