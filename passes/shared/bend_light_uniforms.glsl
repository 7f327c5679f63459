vec3 channel_share;       // the branch's share of each channel's flux
float bend;               // the branch's index of refraction is n_d + bend (n_F - n_C)
float least_share;        // of the light on a cell, below which it is followed no further
CHOICE(both_ways)         // 1: what is mirrored here is followed by another branch
CHOICE(follows_mirrored)  // 1: this is that branch
