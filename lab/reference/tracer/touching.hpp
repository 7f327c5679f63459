// Bodies that touch, as water touches its glass. A ray starts a little before the next surface that it looks
// for, so that it does not meet its own again: of two surfaces in one place it would meet only one.
#pragma once
#include <memory>
#include <vector>

#include "lab/reference/tracer/optics.hpp"

namespace caustics::tracer {

// The scene with its bodies of glass grown by so many metres where they lie on or in another's bounds, so
// that light is in the next body before it leaves the last; null where there are no such.
std::unique_ptr<const Scene> with_overlaps(const Scene& scene, const std::vector<Optics>& optics, double by);

}  // namespace caustics::tracer
