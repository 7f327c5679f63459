float factor;  // from nit to display white
