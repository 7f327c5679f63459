// Exact functions of the common subset: +, -, *, /, sqrt and bits of numbers in a fixed order, so that
// every compiler, lane width and conforming GPU gives the same bits. Included first in every stage.

// Comparisons choose, so NaN gives b (min, max) or lo (clamp) everywhere.
Float min_of(Float a, Float b) { return sel(a < b, a, b); }
Float max_of(Float a, Float b) { return sel(a > b, a, b); }
Float clamp_to(Float x, Float lo, Float hi) { return sel(x >= lo, sel(x <= hi, x, hi), lo); }
Int min_of(Int a, Int b) { return sel(a < b, a, b); }
Int max_of(Int a, Int b) { return sel(a > b, a, b); }
Int clamp_to(Int x, Int lo, Int hi) { return min_of(max_of(x, lo), hi); }

// The largest whole number not above x, for |x| < 2^24; beyond, the border. NaN gives -2^24.
Int floor_to_int(Float x) { return Int(floor(clamp_to(x, -16777216.0f, 16777216.0f))); }

Float dot2(Vec2 a, Vec2 b) { return a.x * b.x + a.y * b.y; }
Float dot3(Vec3 a, Vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Float length3(Vec3 v) { return sqrt(dot3(v, v)); }
Vec3 cross3(Vec3 a, Vec3 b) {
  return Vec3(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
}

// v / |v|, or `fallback` where |v|^2 is below 1e-30 or not a number.
Vec3 normalize_or(Vec3 v, Vec3 fallback) {
  Float squared = dot3(v, v);
  Bool sound = squared > 1.0e-30f;
  return sel(sound, v / sqrt(sel(sound, squared, Float(1.0f))), fallback);
}

// Matrix (columns) times a point with w = 1, and times a vector.
Vec4 transform_point(mat4 m, Vec3 p) {
  return Vec4(((m[0].x * p.x + m[1].x * p.y) + m[2].x * p.z) + m[3].x,
              ((m[0].y * p.x + m[1].y * p.y) + m[2].y * p.z) + m[3].y,
              ((m[0].z * p.x + m[1].z * p.y) + m[2].z * p.z) + m[3].z,
              ((m[0].w * p.x + m[1].w * p.y) + m[2].w * p.z) + m[3].w);
}
Vec3 transform_vector(mat4 m, Vec3 v) {
  return Vec3((m[0].x * v.x + m[1].x * v.y) + m[2].x * v.z,
              (m[0].y * v.x + m[1].y * v.y) + m[2].y * v.z,
              (m[0].z * v.x + m[1].z * v.y) + m[2].z * v.z);
}

// 2^n for a whole n in [-126, 127], beyond which n is the nearer of both: the exponent's bits of IEEE 754.
Float exp2_of_whole(Int n) { return intBitsToFloat((clamp_to(n, Int(-126), Int(127)) + 127) * 8388608); }

// e^x, relative error below 3e-7 for x in [-87, 88]; 0 below -87, e^88 above 88. x = n ln 2 + r with
// |r| <= ln 2 / 2 in two parts (Cody and Waite), then the Taylor polynomial of degree 7.
Float exp_of(Float x) {
  Float y = clamp_to(x, -88.0f, 88.0f);
  Float n = floor(y * 1.44269504f + 0.5f);
  Float r = (y - n * 0.693359375f) + n * 2.12194440e-4f;
  Float p = Float(1.0f / 5040.0f);
  p = p * r + 1.0f / 720.0f;
  p = p * r + 1.0f / 120.0f;
  p = p * r + 1.0f / 24.0f;
  p = p * r + 1.0f / 6.0f;
  p = p * r + 0.5f;
  p = p * r + 1.0f;
  p = p * r + 1.0f;
  return sel(x < -87.0f, Float(0.0f), p * exp2_of_whole(Int(n)));
}

// Natural logarithm of x > 0, relative error below 1e-6 (absolute near 1); x <= 2^-126 gives -87.
// x = m 2^e by the bits of IEEE 754, then ln m = 2 artanh((m-1)/(m+1)).
Float log_of(Float x) {
  Int bits = floatBitsToInt(max_of(x, 1.17549435e-38f));
  Int biased = bits / 8388608;
  Float exponent = Float(biased - 127);
  Float m = intBitsToFloat(bits - biased * 8388608 + 1065353216);
  // m is in [1, 2); centre it on 1.
  Bool upper = m > 1.41421356f;
  m = sel(upper, m * 0.5f, m);
  exponent = sel(upper, exponent + 1.0f, exponent);
  Float s = (m - 1.0f) / (m + 1.0f);
  Float z = s * s;
  Float p = Float(1.0f / 11.0f);
  p = p * z + 1.0f / 9.0f;
  p = p * z + 1.0f / 7.0f;
  p = p * z + 1.0f / 5.0f;
  p = p * z + 1.0f / 3.0f;
  p = p * z + 1.0f;
  return 2.0f * s * p + exponent * 0.693147181f;
}

// x^y for x >= 0; 0 for x <= 0.
Float pow_of(Float x, Float y) { return sel(x > 0.0f, exp_of(y * log_of(x)), Float(0.0f)); }

// The error function, absolute error below 2e-6 in single precision (Abramowitz and Stegun 7.1.28).
Float erf_of(Float x) {
  Float a = clamp_to(sel(x < 0.0f, -x, x), 0.0f, 6.0f);
  Float p = Float(0.0000430638f);
  p = p * a + 0.0002765672f;
  p = p * a + 0.0001520143f;
  p = p * a + 0.0092705272f;
  p = p * a + 0.0422820123f;
  p = p * a + 0.0705230784f;
  p = p * a + 1.0f;
  p = p * p;
  p = p * p;
  p = p * p;
  p = p * p;
  Float positive = 1.0f - 1.0f / p;
  return sel(x < 0.0f, -positive, positive);
}

// arctangent of y / x in (-pi, pi], absolute error below 4e-6; (0, 0) gives 0.
Float atan2_of(Float y, Float x) {
  Float ax = sel(x < 0.0f, -x, x);
  Float ay = sel(y < 0.0f, -y, y);
  Bool steep = ay > ax;
  Float larger = sel(steep, ay, ax);
  Float smaller = sel(steep, ax, ay);
  Float r = sel(larger > 0.0f, smaller / sel(larger > 0.0f, larger, Float(1.0f)), Float(0.0f));
  // tan(pi/8) splits the octant: atan r = pi/4 + atan((r-1)/(r+1)) above.
  Bool upper = r > 0.41421356f;
  Float s = sel(upper, (r - 1.0f) / (r + 1.0f), r);
  Float z = s * s;
  Float p = Float(-1.0f / 11.0f);
  p = p * z + 1.0f / 9.0f;
  p = p * z - 1.0f / 7.0f;
  p = p * z + 1.0f / 5.0f;
  p = p * z - 1.0f / 3.0f;
  p = p * z + 1.0f;
  Float angle = s * p + sel(upper, Float(0.785398163f), Float(0.0f));
  angle = sel(steep, 1.57079633f - angle, angle);
  angle = sel(x < 0.0f, 3.14159265f - angle, angle);
  return sel(y < 0.0f, -angle, angle);
}

// One texel, the coordinates clamped into the texture.
Vec4 fetch_clamped(Texture t, Int x, Int y) {
  return texel_fetch(t, clamp_to(x, Int(0), Int(texture_width(t) - 1)),
                     clamp_to(y, Int(0), Int(texture_height(t) - 1)));
}

// Is (u, v) inside the texture, 0 <= u, v < 1? False for NaN.
Bool inside_unit(Float u, Float v) { return u >= 0.0f && u < 1.0f && v >= 0.0f && v < 1.0f; }

// The texel that holds (u, v), clamped into the texture.
Vec4 fetch_nearest(Texture t, Float u, Float v) {
  return fetch_clamped(t, floor_to_int(u * Float(texture_width(t))),
                       floor_to_int(v * Float(texture_height(t))));
}

// Bilinear interpolation of the four nearest texel centres, clamped to the edge.
Vec4 fetch_bilinear(Texture t, Float u, Float v) {
  Float x = u * Float(texture_width(t)) - 0.5f;
  Float y = v * Float(texture_height(t)) - 0.5f;
  Int x0 = floor_to_int(x);
  Int y0 = floor_to_int(y);
  Float fx = clamp_to(x - Float(x0), 0.0f, 1.0f);
  Float fy = clamp_to(y - Float(y0), 0.0f, 1.0f);
  Vec4 bottom = fetch_clamped(t, x0, y0) * (1.0f - fx) + fetch_clamped(t, x0 + 1, y0) * fx;
  Vec4 top = fetch_clamped(t, x0, y0 + 1) * (1.0f - fx) + fetch_clamped(t, x0 + 1, y0 + 1) * fx;
  return bottom * (1.0f - fy) + top * fy;
}
