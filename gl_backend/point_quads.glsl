// Behind the vertex shader of a pass whose points are drawn as quadrilaterals: moves each of the four
// vertices of an instance to a corner of the pixels that the point covers (pipeline/gpu/point_rule.hpp).
#undef main
layout(location = 0) uniform vec2 target_size;

// Along one axis: the first pixel's outer edge and the last's.
vec2 pixels_of_point(float window, float size) {
  float scaled = (window - 0.5f) * 256.0f;
  float centre = scaled >= 0.0f ? floor(scaled + 0.5f) : -floor(0.5f - scaled);
  float width = floor(size * 256.0f + 0.5f);
  float begin = centre - floor(width * 0.5f);
  return vec2(ceil(begin * 0.00390625f), ceil((begin + width) * 0.00390625f));
}

void main() {
  point_main();
  vec4 at = gl_Position;
  float size = clamp(gl_PointSize, 1.0f, 255.0f);
  // Points are clipped by their centres.
  bool inside = abs(at.x) <= at.w && abs(at.y) <= at.w && at.z >= 0.0f && at.z <= at.w && at.w > 0.0f;
  float reciprocal_w = 1.0f / at.w;
  vec2 middle = target_size * 0.5f;
  vec2 columns = pixels_of_point(at.x * reciprocal_w * middle.x + middle.x, size);
  vec2 rows = pixels_of_point(at.y * reciprocal_w * middle.y + middle.y, size);
  float column = clamp((gl_VertexID & 1) == 0 ? columns.x : columns.y, 0.0f, target_size.x);
  float row = clamp((gl_VertexID & 2) == 0 ? rows.x : rows.y, 0.0f, target_size.y);
  vec4 corner = vec4(column / middle.x - 1.0f, row / middle.y - 1.0f, at.z * reciprocal_w, 1.0f);
  gl_Position = inside ? corner : vec4(2.0f, 2.0f, 2.0f, 1.0f);
}
