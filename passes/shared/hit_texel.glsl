// What a ray meets, as a texel: xy: weights of the triangle's second and third corner; z: metres to it; w:
// its number plus 1, 0 where nothing is met, HIT_GIVEN_UP where the search took too many steps.
Bool is_surface(Vec4 hit) { return hit.w > 0.0f; }
Bool is_on_caster(Vec4 hit) { return is_surface(hit) && hit.w <= float(u.first_receiver); }
Bool is_given_up(Vec4 hit) { return hit.w == float(HIT_GIVEN_UP); }
