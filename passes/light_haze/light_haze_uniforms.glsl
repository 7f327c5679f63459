CameraRays camera;
Medium medium;
Light light;
View shadow_view;    // all views of the light have the same origin and axes
View caster_view;
View pane_view;
CHOICE(has_shadow_map)
CHOICE(has_caustic)  // casters, of which there is a map, bend the light
CHOICE(has_panes)
int steps;           // along the camera's ray
