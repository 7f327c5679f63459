// Textures that other rooms look up by name.
#pragma once
#include <string>

namespace caustics {

// Resources that exist before the first pass.
inline constexpr char kCasterMaterials[] = "caster_materials";
inline constexpr char kEnvironment[] = "environment";

// Of scenes whose light is followed from surface to surface (pipeline/scene/hierarchy_tables.hpp).
inline constexpr char kHierarchyNodes[] = "hierarchy_nodes";
inline constexpr char kHierarchyTriangles[] = "hierarchy_triangles";
inline constexpr char kHierarchyNormals[] = "hierarchy_normals";
// The pictures on casters that have textures (pipeline/scene/caster_texels.hpp).
inline constexpr char kCasterTexels[] = "caster_texels";

inline constexpr char kCasterPosition[] = "caster_position";
inline constexpr char kCasterNormal[] = "caster_normal";
inline constexpr char kWaterStep[] = "water_step";
inline constexpr char kWaterBefore[] = "water_before";
inline constexpr char kLanding[] = "landing";
inline constexpr char kLandingFlux[] = "landing_flux";
inline constexpr char kLandingFresnel[] = "landing_fresnel";
inline constexpr char kLandingAbsorbed[] = "landing_absorbed";
// Of scenes with a medium only.
inline constexpr char kLandingMedium[] = "landing_medium";
// Of light that is followed from surface to surface only.
inline constexpr char kLandingPath[] = "landing_path";
inline constexpr char kLandingFootprint[] = "landing_footprint";
inline constexpr char kCausticMap[] = "caustic_map";
// A finer map of a part of it, for lights with a cascade.
inline constexpr char kCascadeMap[] = "caustic_map.cascade";
inline constexpr char kCellNear[] = "cell_near";
inline constexpr char kCellFar[] = "cell_far";
inline constexpr char kCellFlux[] = "cell_flux";

// The same texture for the farthest receivers that the light sees.
inline std::string far_texture(const std::string& name) { return name + ".far"; }

}  // namespace caustics
