// The vertex stage of every pass that draws meshes into a view. Expects the uniform `view` and the varyings
// surface_position and surface_normal.
void main() {
  surface_position = position;
  surface_normal = normal;
  set_position(view_clip(u.view, view_coordinates(u.view, position)));
}
