mat4 from_scene;       // origin and axes, shared by all views of the light
vec4 receiver_window;
vec4 receiver_depth;
vec4 caustic_window;
vec4 caustic_depth;
vec4 limits;           // CellLimits: jump; smallest jump, texels; largest cell, texels; gap, texels' extents
vec4 tile;             // of a cube's caustic map: width and height of a tile, texels
vec4 grid_tile;        // of a cube's grid: side of a tile and its guard, grid vertices
ivec4 grid;            // grid vertices a side, map texels a side, unused, unused
