// Names for the numbers that shaders and C++ exchange. pipeline/shader/constants.hpp has them for C++.

// How a view sees: parallel rays, rays from a point through a window, or rays from a point all around.
CONSTANT(VIEW_PARALLEL, 0)
CONSTANT(VIEW_PERSPECTIVE, 1)
CONSTANT(VIEW_CUBE, 2)

// The faces of a cube, by the view's axis that they look along: +x, -x, +y, -y, +z, -z. A view that is not a
// cube has only FACE_FORWARD.
CONSTANT(FACE_RIGHT, 0)
CONSTANT(FACE_LEFT, 1)
CONSTANT(FACE_UP, 2)
CONSTANT(FACE_DOWN, 3)
CONSTANT(FACE_FORWARD, 4)
CONSTANT(FACE_BACKWARD, 5)

// How a grid vertex's light ended; the texture `landing` holds it in w.
CONSTANT(STATUS_EMPTY, 0)
CONSTANT(STATUS_LANDED, 1)
CONSTANT(STATUS_MISSED, 2)
CONSTANT(STATUS_OUTSIDE, 3)
CONSTANT(STATUS_TOTAL_REFLECTION, 4)
CONSTANT(STATUS_ABSORBED, 5)
CONSTANT(STATUS_NOT_CONVERGED, 6)
CONSTANT(STATUS_EXIT_NOT_FOUND, 7)
CONSTANT(STATUS_STOPPED, 8)
CONSTANT(STATUS_GIVEN_UP, 9)

// w of what a ray meets (passes/shared/hit_texel.glsl) where the search took too many steps.
CONSTANT(HIT_GIVEN_UP, -1)

// What befalls light at a surface, in its path.
CONSTANT(EVENT_CROSSES, 1)
CONSTANT(EVENT_MIRRORED, 2)
CONSTANT(EVENT_PASSES, 3)

// What finds where a ray meets a surface that a view has seen.
CONSTANT(ESTIMATOR_PAPER, 0)
CONSTANT(ESTIMATOR_SECANT, 1)
CONSTANT(ESTIMATOR_NEWTON, 2)
CONSTANT(ESTIMATOR_IMPOSTOR, 3)
