// Two unit axes across a direction, which make a right-handed set with it (Duff, Burgess, Christensen, Hery,
// Kensler, Liani, Villemin 2017). What is stored across a direction is stored in them.
struct AxesAcross {
  Vec3 x;
  Vec3 y;
};

AxesAcross axes_across(Vec3 d) {
  Float sign = sel(d.z >= 0.0f, Float(1.0f), Float(-1.0f));
  Float a = -1.0f / (sign + d.z);
  Float b = d.x * d.y * a;
  AxesAcross axes;
  axes.x = Vec3(1.0f + sign * d.x * d.x * a, sign * b, -sign * d.x);
  axes.y = Vec3(b, sign + d.y * d.y * a, -d.y);
  return axes;
}
