mat4 from_scene;    // the camera's view
vec4 window;
vec4 depth;
vec4 picture;       // width, height, pixels; widest beam, pixels; pixel's area in window units squared
vec4 intensity;     // rgb: lux (directional) or candela
ivec4 beams;        // a side, unused, unused, unused
