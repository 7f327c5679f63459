Light light;
vec3 caustic_intensity;        // lux or candela: the light's, and that of others for which its caustic stands
View shadow_view;              // all views of the light have the same origin and axes
View caster_view;
View receiver_view;
View caustic_view;
float caustic_side;            // of its map and the cascade's, texels
View cascade_view;             // a window within the caustic map's
View pane_view;
View column;                   // the window that receivers leave free before the casters
float casters_nearest;         // z of the casters' nearest point, metres
CHOICE(has_shadow_map)
CHOICE(has_lift)               // some surfaces bulge over their triangles
CHOICE(has_panes)
CHOICE(has_caustic)            // there are maps of casters, of receivers and of the casters' light on them
CHOICE(looks_aside)            // the maps of receivers and of the casters' light have axes of their own
CHOICE(lights_backs)           // sides that face away take caustics: 1: of the farthest receivers, 2: of all
CHOICE(has_cascade)            // a part of the caustic map in finer texels
CHOICE(receivers_are_layered)  // the receivers farthest from the light have maps of their own
CHOICE(caustic_is_grey)        // caustic maps have one channel
float caustic_texel_area;      // of a caustic map's texel, window units squared
float cascade_texel_area;
float cascade_border;          // map coordinates from the cascade's border that are not looked up
vec2 cascade_from;             // where the caustic map's lower corner lies in the cascade, map coordinates,
vec2 cascade_step;             // and how wide and high one of its texels is there
vec2 tile_reach;               // of a cube: from a tile's middle to its outermost texels' centres, map units
vec3 eye;                      // the camera's position
CHOICE(has_highlights)
CHOICE(is_layer)               // of blended surfaces, or of what only glass shows: not of every pixel; 2: and
                               // of several surfaces one behind the other
CHOICE(casters_shine)          // 1: the picture shows glass and metal before its surfaces; 2: only of what is
                               // seen through panes is that asked; 3: and it does not
CHOICE(has_walls)              // and some of that has no thickness
vec3 forward;                  // the way it looks
int is_perspective;            // 0: all its rays run along that
CHOICE(samples_across)         // of a caustic's mean over a pixel, at most, along an axis; 0: no such mean
