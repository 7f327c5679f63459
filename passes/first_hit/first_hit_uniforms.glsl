mat4 from_scene;  // the camera's view
