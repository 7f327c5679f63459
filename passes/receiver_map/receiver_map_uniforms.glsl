View view;
View column;            // the window which receivers leave free between the light and the casters,
float casters_nearest;  // and up to which z
int map_side;           // of a cube view's map, texels
AlphaMask mask;
