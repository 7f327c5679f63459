// The light tracer's ray queries for tests, where this build has them.
#pragma once
#include "lab/reference/tracer/rays.hpp"
#include "tests/support/skip.hpp"

namespace caustics::test {

inline void need_ray_queries() {
  if (!tracer::has_ray_queries()) skip("no Embree: this build traces no rays");
}

}  // namespace caustics::test
