// Shots of floors that several rows judge, and what is judged of them.
#pragma once
#include "lab/paper/measures.hpp"
#include "lab/paper/row.hpp"
#include "lab/reference/sphere_floor.hpp"

namespace caustics::paper {

// glass_sphere.glb, as scenes/README.md has it.
inline constexpr GlassSphere kSphere{.radius = 0.5, .index = 1.5, .distance = 0.8};

// slab_glass.glb: light 40 degrees from the vertical.
inline constexpr Slab kSlab{.half = 0.5,
                            .thickness = 0.3,
                            .height = 0.5,
                            .index = 1.5,
                            .incidence = 0.6981317007977318,
                            .margin = 0.08};

// The floor of a scene whose camera `floor` sees 2 x 2 m of it. Light is followed through two surfaces, as
// the paper has it and the closed forms.
Shot floor_shot(const std::string& name, const std::string& scene, Options options = {});
// The same by traced light, as the truth of pictures (its own noise: some 2 % of the sphere's caustic).
Shot traced_floor(const std::string& name, const std::string& scene);
// A small frame on a grid and maps of `side`, with all attachments; through two surfaces likewise.
Shot dumped_shot(const std::string& name, const std::string& scene, int side, const Options& options = {});

std::vector<double> floor_irradiance(const Shots& shots, const std::string& name);
SphereFloorError sphere_error(const Shots& shots, const std::string& name);
bool all_closed(const Shots& shots, const std::vector<std::string>& names);  // ledgers, within 1e-5

}  // namespace caustics::paper
