Sky sky;
View view;               // the camera's
View surroundings;       // the same, three times as wide and high
vec3 eye;                // the camera's position
int iterations;          // of the search for a surface
vec3 forward;            // the way the camera looks
vec3 receivers_lower;    // the box around all receivers, scene space
vec3 receivers_upper;
float rough_from;        // from this roughness on the view is spread
CHOICE(has_rough)
CHOICE(has_caster_tint)  // 1: view_caster_tint has the colours, not caster_materials
CHOICE(blends)           // there are blended surfaces
