vec4 factor;  // red, green, blue, alpha
