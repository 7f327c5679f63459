// The camera's rays through the middles of the picture's pixels, as a uniform. Include before UNIFORMS_BEGIN;
// shader_camera_rays() in passes/shared/camera_rays.hpp fills it.
struct CameraRays {
  vec3 origin;         // the camera's position, scene space
  int is_perspective;  // 0: all rays run along `forward`
  vec3 right;          // the camera's axes, scene space
  vec3 up;
  vec3 forward;
  vec2 pixel;          // window coordinates = frag * pixel + corner
  vec2 corner;
};
