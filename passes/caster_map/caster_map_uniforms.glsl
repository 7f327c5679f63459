View view;         // what sees the casters
int material_row;  // in caster_materials
int map_side;      // of a cube view's map, texels
int first_triangle; // of the mesh in the hierarchy
