View caster;
LightCone cone;
vec3 light;         // of parallel light the direction of travel, else the position; scene space
float cell_area;    // 1: flux is counted in that of a cell in the view's middle
float tile_width;   // of a cube's caster map, texels
float tile_height;
float tile_guard;
int grid_side;      // grid vertices
