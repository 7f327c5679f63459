// Which triangle a ray meets first, found in the bounding-volume hierarchy that the textures hierarchy_nodes
// and hierarchy_triangles hold (pipeline/scene/hierarchy_tables.hpp). The order of the walk is the ray's own
// and nobody else's, so every device and lane width finds the same. Needs axes_across.glsl, ray.glsl and
// the uniforms of next_surface.

// A ray as boxes and triangles meet it.
struct WalkingRay {
  Ray ray;
  Vec3 inverse;     // of each component of its direction, finite
  AxesAcross axes;
  Float own;        // number of the triangle that it starts on and does not meet; -1: none
};

struct NearestTriangle {
  Float distance;  // metres
  Float number;    // -1: none
  Float weight1;   // of the triangle's second corner,
  Float weight2;   // and of its third
  Bool given_up;   // the walk took more steps than it may
};

Float nothing_met() { return Float(1.0e30f); }
Float finite_inverse(Float x) {
  Bool sound = abs(x) > 1.0e-30f;
  return sel(sound, 1.0f / sel(sound, x, Float(1.0f)), sel(x < 0.0f, Float(-1.0e30f), Float(1.0e30f)));
}

WalkingRay walking_ray(IN(Ray) ray, Float own) {
  WalkingRay walking;
  walking.ray = ray;
  walking.inverse = Vec3(finite_inverse(ray.direction.x), finite_inverse(ray.direction.y),
                         finite_inverse(ray.direction.z));
  walking.axes = axes_across(ray.direction);
  walking.own = own;
  return walking;
}

// How far off a box is; nothing_met() where the ray misses it, or has met something before it. Slabs (Kay and
// Kajiya 1986), the way out lengthened by what rounding may have taken of it (Ize 2013).
Float box_distance(IN(WalkingRay) walking, Vec4 lower, Vec4 upper, Float nearest) {
  Vec3 a = (Vec3(lower) - walking.ray.start) * walking.inverse;
  Vec3 b = (Vec3(upper) - walking.ray.start) * walking.inverse;
  Float enters = max_of(max_of(min_of(a.x, b.x), min_of(a.y, b.y)), max_of(min_of(a.z, b.z), Float(0.0f)));
  Float leaves = min_of(min_of(max_of(a.x, b.x), max_of(a.y, b.y)), max_of(a.z, b.z));
  return sel(enters <= leaves * 1.0000005f && enters <= nearest, enters, nothing_met());
}

// A corner with the ray's start as origin and the ray as z.
Vec3 along_ray(IN(WalkingRay) walking, Vec4 corner) {
  Vec3 q = Vec3(corner) - walking.ray.start;
  return Vec3(dot3(walking.axes.x, q), dot3(walking.axes.y, q), dot3(walking.ray.direction, q));
}

// Where triangles count as met: casters from the ray's start on. Receivers by u.touch later than they are, so
// that light leaves the glass that stands on them first; from in front even a little behind the start, which
// rounding may have put beyond them.
Float counted_distance(Float distance, Float number, Bool front) {
  Bool receiver = number >= float(u.first_receiver);
  Float counted = sel(receiver, distance + u.touch, distance);
  return sel(receiver && !front && distance < u.touch, Float(-1.0f), counted);
}

// No ray slips between two triangles that share an edge: the edge's functions are each other's negatives, and
// 0 counts as inside (Woop, Benthin, Wald 2013). Of two triangles at the same distance the one with the
// smaller number is met.
void meet_triangle(IN(WalkingRay) walking, Int place, Bool wanted, INOUT(NearestTriangle) nearest) {
  Int first = place * 3;
  Vec4 corner0 = table_fetch(hierarchy_triangles, first, 0);
  Vec4 corner1 = table_fetch(hierarchy_triangles, first, 1);
  Vec4 corner2 = table_fetch(hierarchy_triangles, first, 2);
  Vec3 a = along_ray(walking, corner0);
  Vec3 b = along_ray(walking, corner1);
  Vec3 c = along_ray(walking, corner2);
  Float u0 = c.x * b.y - c.y * b.x;
  Float u1 = a.x * c.y - a.y * c.x;
  Float u2 = b.x * a.y - b.y * a.x;
  Bool inside = (u0 >= 0.0f && u1 >= 0.0f && u2 >= 0.0f) || (u0 <= 0.0f && u1 <= 0.0f && u2 <= 0.0f);
  Float area = (u0 + u1) + u2;
  Bool edge_on = area == 0.0f;
  Float inverse = 1.0f / sel(edge_on, Float(1.0f), area);
  Float number = corner0.w;
  Float distance = ((u0 * a.z + u1 * b.z) + u2 * c.z) * inverse;
  distance = counted_distance(distance, number, area > 0.0f);
  Bool nearer = distance < nearest.distance || (distance == nearest.distance && number < nearest.number);
  Bool met = wanted && inside && !edge_on && number != walking.own && distance >= 0.0f && nearer;
  nearest.distance = sel(met, distance, nearest.distance);
  nearest.number = sel(met, number, nearest.number);
  nearest.weight1 = sel(met, u1 * inverse, nearest.weight1);
  nearest.weight2 = sel(met, u2 * inverse, nearest.weight2);
}

// What a node says of a child, as one number: of an inner node where it stands, from 0 on; of a leaf minus
// eight times its first triangle, minus how many these are.
Int child_code(Float first, Float count) {
  Int at = Int(first);
  return sel(count > 0.0f, -(at * 8 + Int(count)), at);
}

// The children of the next node that are still to be visited.
struct Children {
  Int nearer;
  Int farther;
  Bool any;
  Bool both;
};

Children children_of(IN(WalkingRay) walking, Int node, Float nearest) {
  Int first = node * 4;
  Vec4 lower0 = table_fetch(hierarchy_nodes, first, 0);
  Vec4 upper0 = table_fetch(hierarchy_nodes, first, 1);
  Vec4 lower1 = table_fetch(hierarchy_nodes, first, 2);
  Vec4 upper1 = table_fetch(hierarchy_nodes, first, 3);
  Float distance0 = box_distance(walking, lower0, upper0, nearest);
  Float distance1 = box_distance(walking, lower1, upper1, nearest);
  Int code0 = child_code(lower0.w, upper0.w);
  Int code1 = child_code(lower1.w, upper1.w);
  Bool in_order = distance0 <= distance1;
  Children children;
  children.nearer = sel(in_order, code0, code1);
  children.farther = sel(in_order, code1, code0);
  children.any = distance0 < nothing_met() || distance1 < nothing_met();
  children.both = distance0 < nothing_met() && distance1 < nothing_met();
  return children;
}

STACK(waiting)

NearestTriangle nearest_triangle(IN(WalkingRay) walking, Bool walks) {
  NearestTriangle nearest;
  nearest.distance = nothing_met();
  nearest.number = Float(-1.0f);
  nearest.weight1 = Float(0.0f);
  nearest.weight2 = Float(0.0f);
  Int depth = Int(0);
  Int code = Int(0);
  Bool busy = walks;
  for (int step = 0; step < u.most_steps && any_lane(busy); step++) {
    Bool inner = busy && code >= 0;
    Bool leaf = busy && code < 0;
    Bool done = Bool(false);
    if (any_lane(inner)) {
      Children children = children_of(walking, sel(inner, code, Int(0)), nearest.distance);
      stack_put(waiting, depth, children.farther);
      depth = sel(inner && children.both, depth + 1, depth);
      code = sel(inner, children.nearer, code);
      done = inner && !children.any;
    }
    if (any_lane(leaf)) {
      Int filled = sel(leaf, -code, Int(8));
      Int place = filled / 8;
      meet_triangle(walking, place, leaf, nearest);
      done = done || (leaf && filled - place * 8 == 1);
      code = sel(leaf, code - 7, code);
    }
    busy = busy && !(done && depth == 0);
    depth = sel(done, max_of(depth - 1, Int(0)), depth);
    if (any_lane(done)) code = sel(done && busy, stack_at(waiting, depth), code);
  }
  nearest.given_up = busy;
  return nearest;
}
