// The vertex stage of every pass that draws meshes into a frame. Expects the uniforms from_scene,
// window and depth of that frame and the varyings surface_position and surface_normal.
void main() {
  surface_position = position;
  surface_normal = normal;
  set_position(view_clip(view_coordinates(u.from_scene, position), u.window, u.depth));
}
