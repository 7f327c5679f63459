vec4 wave;        // (speed / dx)^2 dt and (speed / dz)^2 dt, 1/s; 1 / (1 + damping dt); dt, s
vec4 plop_place;  // column and row of the plop's middle, in cells from the corner; unused; unused
vec4 plop_shape;  // dx / radius, dz / radius, metres added at its middle in this step, its ring's factor
