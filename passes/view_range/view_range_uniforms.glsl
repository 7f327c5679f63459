CameraRays camera;
View view;      // the camera's
Medium medium;
