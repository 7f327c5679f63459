// Does a fragment drawn into a cube view lie outside the tile of the face that is drawn? Triangles reach over
// their tile's border. `side`: of the texture, texels. False where the view is no cube. Needs
// cube_atlas.glsl.
Bool outside_tile(IN(View) view, int side) {
  Bool outside = Bool(false);
  if (view.kind == VIEW_CUBE) {
    // Half a tile in texels, to a quarter: rounding of the uniforms moves it by less.
    Float half_width = floor(Float((4.0f * float(side)) * view.offset.x + 0.5f)) * 0.25f;
    Float half_height = floor(Float((4.0f * float(side)) * view.offset.y + 0.5f)) * 0.25f;
    Vec2 middle = cube_middle(Int(view.face));
    outside = abs(frag_x() - middle.x * half_width) > half_width ||
              abs(frag_y() - middle.y * half_height) > half_height;
  }
  return outside;
}
