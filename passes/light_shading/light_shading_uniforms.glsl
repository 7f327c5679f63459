mat4 from_scene;         // origin and axes, shared by all views of the light
vec4 caster_window;
vec4 caster_depth;
vec4 receiver_window;
vec4 receiver_depth;
vec4 caustic_window;
vec4 caustic_depth;
vec4 shadow_window;
vec4 shadow_range;       // the shadow view's depth
vec4 pane_window;
vec4 pane_depth;
vec4 light;              // xyz: direction of travel (directional) or position; w: 1 for a position
vec4 cone_axis;
vec4 cone;
vec4 intensity;          // rgb: lux (directional) or candela; w: range in metres, 0 for none
vec4 column;             // the window that receivers leave free before the casters, and
vec4 column_depth;       // its depth range; w: z of the casters' nearest point
vec4 caustic_texel;      // x: area of a caustic map texel in window units squared; y, z: of a cube, from a
                         // tile's middle to its outermost texels' centres, in map coordinates; w: 1 where the map has one channel
vec4 cascade_window;
vec4 cascade_texel;      // x: area of a cascade's texel in window units squared; y: map coordinates from the cascade's
                         // border that are not looked up; z: 1 where there is a cascade; w: 1 where there are far receivers
vec4 uses;               // 1 where there is a shadow map, a caster map, a caustic map, thin panes
vec4 footprint;          // x: by how many samples along an axis a caustic is averaged over a pixel at most; 0: it is not
