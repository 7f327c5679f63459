float exposure;  // factor from nit to display white
float contrast;  // power by which brightness over a mid grey grows, >= 1
float contrast_in_dark;  // and that under it shrinks
CHOICE(is_linear)  // what is brighter than display white is cut off
