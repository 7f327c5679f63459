View map;
int grid_side;       // grid vertices
int map_side;        // texels
CHOICE(has_cells)    // 1: cells have taken their part
float radius;        // of the kernel, texels; 0: no kernel, a point falls on one texel
float sharpness;     // 1 / (sigma sqrt 2)
float inverse_mass;  // of the kernel inside its radius, along an axis
float point_size;    // pixels
