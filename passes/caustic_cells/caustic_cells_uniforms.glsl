vec2 scale;   // from texels of the caustic map to those of the one that is drawn
vec2 offset;
int cells_a_side;
int map_side;  // texels
