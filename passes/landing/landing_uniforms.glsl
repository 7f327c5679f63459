mat4 from_scene;       // origin and axes, shared by all views of the light
vec4 caster_window;
vec4 caster_depth;
vec4 receiver_window;
vec4 receiver_depth;
vec4 caustic_window;
vec4 caustic_depth;
vec4 light;            // xyz: direction of travel (parallel) or position (perspective), scene space
vec4 cone_axis;        // xyz: unit axis of a spot light's cone, the way it shines
vec4 cone;             // scale and offset of the cone's falloff; x = 0 where there is none; z: 1 for a plain cosine
vec4 cell;             // x: area of a grid cell in window units squared; y, z: tolerance of the exit and of
                       // the landing, in texels' extents; w: 1 where there are mirrors
vec4 receivers_lower;  // the box around all receivers, scene space
vec4 receivers_upper;
vec4 tile;             // of a cube's caster map: width and height of a tile, and its guard, texels; w: 1 for a cube
vec4 branch;           // rgb: share of each channel; w: bend, the index of refraction is n_d + bend (n_F - n_C)
mat4 impostor_from_scene;  // the cube around the casters
vec4 impostor_window;
vec4 impostor_depth;
vec4 impostor_centre;  // xyz: its origin, scene space
ivec4 method;          // iterations; estimator (0 paper, 1 secant, 2 newton, 3 impostor); weights (0 physical, 1 paper); solid casters (0, 1)
ivec4 variant;         // 1: what dielectrics mirror, not what they let in; way inside (0 met in the exit map, 1 Wyman's
                       // thickness); 1: caster_tint has the colours; 1: only what landed_before has
                       // not converged
