View view;         // the camera's
vec2 picture;      // width and height, pixels
float widest;      // no beam is drawn wider, pixels
float pixel_area;  // window units squared
vec3 intensity;    // lux (directional) or candela
int beams_a_side;
Medium medium;
