vec4 exposure;  // x: factor from nit to display white
