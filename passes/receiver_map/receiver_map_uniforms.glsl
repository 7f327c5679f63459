View view;
View column;            // the window which receivers leave free between the light and the casters,
float casters_nearest;  // and up to which z
int map_side;           // of a cube view's map, texels
int without_towards;    // 1: sides whose outward normal faces the light are left out,
int without_away;       // or those whose does not
AlphaMask mask;
