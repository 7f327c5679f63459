vec4 from_map;  // scale and offset from texels of the caustic map to those of the cascade
ivec4 grid;     // cells a side, map texels a side, unused, unused
