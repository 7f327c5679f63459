// Where light that has left a caster lands, by the estimator that was asked for. Needs intersect.glsl, the
// uniforms of receiver_search_uniforms.glsl, and the textures receiver_position and impostor_position.

// Where the ray meets the surface, by the estimator that was asked for.
Hit find_surface(Texture positions, IN(View) view, IN(Search) along) {
  Search search = along;
  search.start = u.search_start;
  search.epsilon = u.newton_epsilon;
  search.guarded = u.newton_guard != 0;
  Hit hit;
  if (u.estimator == ESTIMATOR_PAPER) {
    hit = intersect_paper(positions, view, search);
  } else if (u.estimator == ESTIMATOR_NEWTON) {
    hit = intersect_newton(positions, view, search);
  } else {
    hit = intersect_secant(positions, view, search);
  }
  return hit;
}

// Where a ray starts over a hole, or flies far over a floor's edge, only the box tells where steps have to
// look: from a little before it, by what texels may be off their surfaces, to a little behind it. The last of
// 20 steps, each half as far again as the one before, ends there: 1.5^19 = 2216.8 times the first.
Search search_in_box(IN(Ray) ray, IN(Crossing) box) {
  Search search = search_along(u.receiver, ray, u.iterations, false);
  Float margin = 8.0f * texel_extent_at(receiver_position, u.receiver, point_along(ray, box.enters));
  Float first = max_of(box.enters - margin, Float(0.0f));
  search.first = sel(box.meets, first, Float(0.0f));
  search.reach = sel(box.meets, (box.leaves + margin - first) * (1024.0f / 2216.8378f), Float(0.0f));
  return search;
}

// Impostors are for the landing only: what a ray leaves a solid through is found by the secant.
Hit find_receiver(IN(Ray) ray, IN(Crossing) box) {
  Hit hit;
  if (u.estimator == ESTIMATOR_IMPOSTOR) {
    hit = intersect_impostor(impostor_position, u.impostor, Vec3(u.impostor_centre), ray, u.iterations);
  } else {
    hit = find_surface(receiver_position, u.receiver, search_in_box(ray, box));
  }
  return hit;
}

struct Landing {
  Vec3 point;
  Float flight;    // from the caster, metres
  Hit hit;
  Bool converged;  // the search ended on a surface
  Bool lands;      // it did, or its light is drawn where it stopped
  Bool possible;   // the ray meets the box around all receivers
};

Landing fly_to_receiver(IN(Ray) ray) {
  Landing end;
  Crossing box = cross_receivers(ray);
  end.possible = box.meets;
  end.hit = find_receiver(ray, box);
  end.flight = max_of(end.hit.distance, 0.0f);
  end.point = point_along(ray, end.flight);
  Float tolerance = u.landing_tolerance * texel_extent_at(receiver_position, u.receiver, end.point);
  if (u.estimator == ESTIMATOR_IMPOSTOR)
    tolerance = u.landing_tolerance * texel_extent_at(impostor_position, u.impostor, end.point);
  end.converged = end.hit.residual <= tolerance;
  end.lands = end.converged;
  if (u.draws_unconverged != 0) end.lands = is_found(end.hit);
  TRACE(landing_point, end.point);
  TRACE(landing_residual, end.hit.residual);
  return end;
}
