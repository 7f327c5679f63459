// Which triangle a ray meets first, found in the bounding-volume hierarchy that the textures hierarchy_nodes
// and hierarchy_triangles hold (pipeline/scene/hierarchy_tables.hpp). The order of the walk is the ray's own
// and nobody else's, so every device and lane width finds the same. Blended surfaces, whose body is -1, are
// met where SIGHT is defined. Needs axes_across.glsl, ray.glsl, the texture hierarchy_normals, and the
// uniforms most_steps, first_receiver and touch.

// A ray as boxes and triangles meet it.
struct WalkingRay {
  Ray ray;
  Vec3 inverse;     // of each component of its direction, finite
  AxesAcross axes;
  Float own;        // number of the triangle that it starts on and does not meet; -1: none
  Float own_body;   // that it bounds
  Vec4 media;       // the bodies that the ray is in
};

struct NearestTriangle {
  Float counted;   // metres to where it counts as met
  Float distance;  // and to itself
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

// Of a triangle, by its number; of one that there is not, any.
Float body_of(Float number) {
  Int last = Int(texture_height(hierarchy_normals) * 4096 - 3);
  Int at = clamp_to(Int(number) * 3, Int(0), last);
  Int place = Int(table_fetch(hierarchy_normals, at, 0).w);
  return table_fetch(hierarchy_triangles, place * 3, 2).w;
}

WalkingRay walking_ray(IN(Ray) ray, Float own, Vec4 media) {
  WalkingRay walking;
  walking.ray = ray;
  walking.inverse = Vec3(finite_inverse(ray.direction.x), finite_inverse(ray.direction.y),
                         finite_inverse(ray.direction.z));
  walking.axes = axes_across(ray.direction);
  walking.own = own;
  walking.own_body = body_of(own);
  walking.media = media;
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

// A triangle that a ray's line meets.
struct Candidate {
  Float distance;  // metres
  Float body;      // that it bounds
  Bool front;      // it is met from outside
  Bool receiver;
};

// Metres within which two casters' surfaces are one: rounding decides which of them comes first.
Float contact() { return Float(u.touch * 0.5f); }

// Where a triangle counts as met. Casters' backs by contact() later than they are, so that light enters the
// liquid before it leaves the glass around it: it goes from the one into the other, with no air between.
// Receivers by u.touch, so that light leaves the glass that stands on them first; from in front even a little
// behind the start, which rounding may have put beyond them.
Float counted_distance(IN(Candidate) at) {
  Float counted = at.distance + sel(at.front, Float(0.0f), contact());
  counted = sel(at.receiver, at.distance + u.touch, counted);
  return sel(at.receiver && !at.front && at.distance < u.touch, Float(-1.0f), counted);
}

// A caster's surface in the place that the ray starts in has been met before, or it is behind the start by
// rounding alone: the bodies that the ray is in tell. It is entered, once, and not where it has just been
// left; from behind only by light that has entered something here. It is left by light that is in it.
Bool changes_bodies(IN(WalkingRay) walking, IN(Candidate) at) {
  Bool within = is_in_body(walking.media, at.body);
  Bool has_entered = is_in_body(walking.media, walking.own_body);
  Bool enters = !within && at.body != walking.own_body && (has_entered || at.distance >= 0.0f);
  return sel(at.front, enters, within);
}

Bool is_ahead(IN(WalkingRay) walking, IN(Candidate) at) {
  Bool touches = at.distance >= -contact() && at.distance <= contact();
  Bool ahead = sel(touches, changes_bodies(walking, at), at.distance > 0.0f);
  return sel(at.receiver, counted_distance(at) >= 0.0f, ahead);
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
  Candidate at;
  at.distance = ((u0 * a.z + u1 * b.z) + u2 * c.z) * inverse;
  at.body = corner2.w;
  at.front = area > 0.0f;
  at.receiver = number >= float(u.first_receiver);
  Float counted = counted_distance(at);
  Bool nearer = counted < nearest.counted || (counted == nearest.counted && number < nearest.number);
  Bool met = wanted && inside && !edge_on && number != walking.own && is_ahead(walking, at) && nearer;
#ifndef SIGHT
  met = met && at.body >= 0.0f;
#endif
  nearest.counted = sel(met, counted, nearest.counted);
  nearest.distance = sel(met, max_of(at.distance, 0.0f), nearest.distance);
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

// `reach`: metres beyond which nothing is met.
NearestTriangle nearest_triangle(IN(WalkingRay) walking, Bool walks, Float reach) {
  NearestTriangle nearest;
  nearest.counted = reach;
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
      Children children = children_of(walking, sel(inner, code, Int(0)), nearest.counted);
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

// As hit_texel.glsl has it. `own`: number of the triangle that the ray starts on; `media`: the bodies that it
// is in.
Vec4 hit_ahead(IN(Ray) ray, Float own, Vec4 media, Bool walks) {
  NearestTriangle nearest = nearest_triangle(walking_ray(ray, own, media), walks, nothing_met());
  Float number = sel(nearest.given_up, Float(HIT_GIVEN_UP), nearest.number + 1.0f);
  Bool met = walks && number != 0.0f;
  return sel(met, Vec4(nearest.weight1, nearest.weight2, nearest.distance, number), Vec4(0.0f));
}
