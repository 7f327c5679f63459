View receiver;
View caustic;         // the map that the cells are laid into
float jump;           // CellLimits: times its neighbours' length that an edge may be long,
float smallest_jump;  // or so many texels;
float expected;       // times a differential that a landing may be off its expected place;
float largest;        // texels that a cell may span;
float gap;            // between the receiver and the cell's middle, texels' extents
float tile_width;     // of a cube's caustic map, texels
float tile_height;
float grid_tile;      // of a cube's grid: side of a tile and its guard, grid vertices
float grid_guard;
int grid_side;        // grid vertices
int map_side;         // texels
