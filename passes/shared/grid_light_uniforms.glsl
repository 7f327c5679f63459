View caster;              // the light's view of the casters: its grid
LightCone cone;
vec3 light;               // of parallel light the direction of travel, else the position; scene space
float cell_area;          // of a grid cell, window units squared
float tile_width;         // of a cube's caster map, texels
float tile_height;
float tile_guard;
int grid_side;            // vertices
