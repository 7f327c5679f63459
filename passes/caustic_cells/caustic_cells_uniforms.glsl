ivec4 grid;  // cells a side, map texels a side, unused, unused
