// A view as shaders get it: u = x / w * scale.x + offset.x and v = y / w * scale.y + offset.y, with w = 1
// (parallel) or z (perspective). Of a cube `offset` is half a tile, which a tile's column and row multiply.
// pipeline/scene/view.hpp says what view coordinates are.
struct View {
  mat4 from_scene;  // scene space to view coordinates
  vec2 scale;
  vec2 offset;
  float near;  // the range of z, metres; of a cube, of each face's z
  float far;
  int kind;    // VIEW_PARALLEL, VIEW_PERSPECTIVE or VIEW_CUBE
  int face;    // of a cube: the face that is drawn
};
