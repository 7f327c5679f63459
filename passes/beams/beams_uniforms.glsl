int grid_side;          // grid vertices
int vertices_per_beam;  // along a side
