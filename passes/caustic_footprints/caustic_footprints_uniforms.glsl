View map;
vec2 scale;     // from parts of the caustic map to texels of the one that is drawn
vec2 offset;
float largest;  // texels that a footprint may span
int grid_side;  // vertices
int map_side;   // texels
int is_part;    // 1: of a map that shows more, which keeps the light beyond this one's edges
