ivec4 grid;  // grid vertices a side, grid vertices a beam and side, unused, unused
