View caster_view;    // the light's
CHOICE(has_shadow_map)
CHOICE(has_caustic)  // there is a map of the light's casters
CHOICE(has_panes)
int blocks;          // a side, of which each map is divided into
