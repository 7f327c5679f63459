// The head of the passes that draw casters into a view: plain, or DETAILED with the normals and holes of
// their textures, or TINTED with their colours too (textured_casters.md).
#include "passes/shared/texture_transform.glsl"
UNIFORMS_BEGIN
#ifdef DETAILED
#include "passes/shared/textured_casters_uniforms.glsl"
#else
#include "passes/caster_map/caster_map_uniforms.glsl"
#endif
UNIFORMS_END
#ifdef DETAILED
TEXTURE(0, base_color)
TEXTURE(1, normal_texture)
#ifdef TINTED
TEXTURE(2, transmission_texture)
#endif
#include "passes/shared/textured_surface.glsl"
#else
#include "passes/shared/plain_surface.glsl"
#endif

#ifndef VERTEX_STAGE
#include "passes/shared/edge_on.glsl"
#endif
