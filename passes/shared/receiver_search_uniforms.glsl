View receiver;            // the light's view of what its light can land on
View impostor;            // the cube around the casters
vec3 receivers_lower;     // the box around all receivers, scene space
float landing_tolerance;  // how far from its surface a ray may end and still have met it, texels' extents
vec3 receivers_upper;
float search_start;       // of the estimators paper and newton, metres
vec3 impostor_centre;     // scene space
float newton_epsilon;     // metres; 0: a texel's extent
int iterations;
CHOICE(newton_guard)      // 1: no step where the slope is lost, nor beyond the view's depth
CHOICE(draws_unconverged) // 1: what has not converged is drawn where its search stopped
CHOICE(estimator)         // ESTIMATOR_PAPER ...
