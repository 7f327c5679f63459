// A surface into two float targets, as the receiver and caster maps are drawn.
ATTRIBUTE(0, Vec3, position)
ATTRIBUTE(3, Vec3, normal)
VARYING_SMOOTH(0, Vec3, surface_position)
VARYING_SMOOTH(3, Vec3, surface_normal)

#ifdef VERTEX_STAGE
void main() {
  surface_position = position;
  surface_normal = normal;
  set_position(Vec4(position.x, position.y, position.z, Float(1.0f)));
}
#else
OUTPUT(0, Vec4, position_out)
OUTPUT(1, Vec4, normal_out)

void main() {
  position_out = Vec4(surface_position.x, surface_position.y, surface_position.z, Float(1.0f));
  normal_out = Vec4(surface_normal.x, surface_normal.y, surface_normal.z, Float(0.0f));
}
#endif
