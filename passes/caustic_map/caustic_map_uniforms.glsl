mat4 from_scene;   // the caustic view
vec4 window;
vec4 depth;
vec4 kernel;       // radius in texels (0: point splats); 1 / (sigma sqrt 2); 1 / mass per axis; point size in pixels
ivec4 grid;        // grid vertices a side, map texels a side, 1 where cells take their part, unused
