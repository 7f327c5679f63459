float pull_x;       // (speed / dx)^2 dt, 1/s
float pull_z;       // (speed / dz)^2 dt, 1/s
float damping;      // factor on the rate, 1 / (1 + damping dt)
float time_step;    // s
vec2 plop_middle;   // column and row, in cells from the corner
vec2 plop_scale;    // dx / radius, dz / radius
float plop_height;  // metres added at its middle in this step; 0: no plop
float plop_ring;    // its ring's factor
