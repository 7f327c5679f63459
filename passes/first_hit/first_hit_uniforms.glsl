View view;  // the camera's
