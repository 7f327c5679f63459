mat4 light_from_scene;   // origin and axes, shared by all views of the light
vec4 caster_window;
vec4 caster_depth;
vec4 shadow_window;
vec4 shadow_range;       // the shadow view's depth
vec4 pane_window;
vec4 pane_depth;
vec4 light;              // xyz: direction of travel (directional) or position; w: 1 for a position
vec4 cone_axis;
vec4 cone;
vec4 intensity;          // rgb: lux (directional) or candela; w: range in metres, 0 for none
vec4 uses;               // 1 where there is a shadow map, a caster map, thin panes
ivec4 steps;             // along the ray, unused, unused, unused
