mat4 from_scene;  // the frame that sees the casters
vec4 window;
vec4 depth;
vec4 material;    // row of the material in caster_materials, side of a cube view's map, unused, unused
