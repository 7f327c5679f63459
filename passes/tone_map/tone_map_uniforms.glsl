float exposure;  // factor from nit to display white
