int grid_side;          // grid vertices
int vertices_per_beam;  // along a side
CHOICE(draws)  // 1: neighbours go ways of their own, of which one is drawn for the beam
