vec4 medium_lower;   // xyz: the medium's box, scene space; w: anisotropy
vec4 medium_upper;   // w: 1 where all channels are alike
vec4 extinction;     // rgb: per metre
vec4 scattering;     // rgb: per metre
