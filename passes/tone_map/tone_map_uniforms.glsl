float exposure;  // factor from nit to display white
CHOICE(is_linear)  // what is brighter than display white is cut off
