int cells_a_side;
int map_side;  // texels
