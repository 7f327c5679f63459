// Does a fragment drawn into a cube view lie outside the tile of the face that is drawn (depth.w)? Triangles reach
// over their tile's border. `side`: of the texture, texels. Needs cube_atlas.glsl.
Bool outside_tile(vec4 window, vec4 depth, float side) {
  // Half a tile in texels, to a quarter: rounding of the uniforms moves it by less.
  Float half_width = floor(Float((4.0f * side) * window.z + 0.5f)) * 0.25f;
  Float half_height = floor(Float((4.0f * side) * window.w + 0.5f)) * 0.25f;
  Vec2 middle = cube_middle(floor_to_int(Float(depth.w)));
  return abs(frag_x() - middle.x * half_width) > half_width ||
         abs(frag_y() - middle.y * half_height) > half_height;
}

// The same with the view as one argument. False where the view is no cube.
Bool outside_tile(IN(View) view, float side) {
  Bool outside = Bool(false);
  if (view.kind == VIEW_CUBE) {
    // Half a tile in texels, to a quarter: rounding of the uniforms moves it by less.
    Float half_width = floor(Float((4.0f * side) * view.offset.x + 0.5f)) * 0.25f;
    Float half_height = floor(Float((4.0f * side) * view.offset.y + 0.5f)) * 0.25f;
    Vec2 middle = cube_middle(Int(view.face));
    outside = abs(frag_x() - middle.x * half_width) > half_width ||
              abs(frag_y() - middle.y * half_height) > half_height;
  }
  return outside;
}
