mat4 from_scene;    // the camera's view
vec4 window;
vec4 depth;
vec4 eye;           // xyz: the camera's position; w: 1 in a perspective view
vec4 right;         // the camera's axes, scene space
vec4 up;
vec4 forward;
vec4 pixel;         // window coordinates = (frag_x * x + z, frag_y * y + w)
