vec4 sky_zenith;   // rgb: nit
vec4 sky_horizon;  // rgb: nit; w: 1 where there is an environment image
vec4 sky_ground;   // rgb: nit
