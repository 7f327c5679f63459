// What rows measure on the attachments of passes. Lengths in metres, scene space.
#pragma once
#include <vector>

#include "lab/paper/shots.hpp"
#include "lab/reference/closed_forms.hpp"

namespace caustics::paper {

// The value that a share of all values does not exceed, 0 of none: the middle one at 0.5.
double percentile(std::vector<double> values, double share);

// Did the grid vertex's light land? `landing`'s texel.
bool has_landed(const std::array<double, 4>& landing);

// A slab that parallel light enters by its upper face, at `incidence` radians from the normal, and leaves by
// its lower, travelling along +x in plan view: how far landings lie from where Snell's law has them. Vertices
// whose light leaves by a side, or within `margin` of an edge, where texels of the exit map hold two faces,
// are left out.
struct Slab {
  double half = 0.5, thickness = 0.3, height = 0.5;  // of its lower face above the floor
  double index = 1.5, incidence = 0.0, margin = 0.0;
};
std::vector<double> slab_errors(const Slab& slab, const Texels& entry, const Texels& landing);

// Light straight down through a sphere whose middle lies over (0, 0) in plan view: how far landings lie from
// the closed form's.
std::vector<double> sphere_errors(const GlassSphere& sphere, const Texels& entry, const Texels& landing);

// How far the same grid vertices' landings are apart, of those that have landed in both.
std::vector<double> distances(const Texels& a, const Texels& b);

// By Beer and Lambert, flux of channel b over that of channel a is exp(-(k_b - k_a) d), k the absorption per
// metre and d the way: the largest relative deviation over all grid vertices, from d as `way` has it for each
// (negative: not counted).
double worst_tint(const Texels& flux, const std::vector<double>& way,
                  const std::array<double, 3>& absorption);

// Of grid vertices: the flux onto each, and what the paper's equation 6 gives it, (1/V) N.L of all flux.
struct VertexWeights {
  std::vector<double> flux, literal;
};

// Those of a sphere under a point light `distance` radii from its middle, without a picture. The light's view
// spreads vertices evenly over the disc of t < tan a, sin a = 1 / distance, t the tangent of the angle to its
// axis. Flux goes with a texel's solid angle, (1 + t^2)^-1.5, and N.L is sqrt(1 - (distance sin)^2).
VertexWeights weights_under_lamp(double distance);

// Relative L1 of the weights once both add up to the same.
struct WeightErrors {
  double equal_parts = 0.0;  // of literal ones against flux times N.L: what 1/V does; none in parallel light
  double literal = 0.0;      // against the flux
};
WeightErrors weight_errors(const VertexWeights& weights);

double sum_of(const std::vector<double>& values);

// The largest distance of a texel's x and z from an even lattice through all texels, and of its height from
// the mean one: a level floor seen straight from above.
double worst_of_lattice(const Texels& positions);

}  // namespace caustics::paper
