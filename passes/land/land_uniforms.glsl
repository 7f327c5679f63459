View receiver;            // the light's view of what its light can land on
View caustic;             // the light's map that the landings are laid into
vec3 channel_share;       // the branch's share of each channel's flux
int first_receiver;       // number of the first triangle that is no caster's
CHOICE(can_be_hidden)     // 1: receivers may hide others from the light
CHOICE(is_last_round)     // 1: light that meets a further caster is given up
