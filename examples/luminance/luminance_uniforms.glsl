vec3 weights;  // of red, green and blue
