int most_steps;      // of a ray's walk through the hierarchy
int first_receiver;  // number of the first triangle that is no caster's
float touch;         // metres: surfaces that are as near touch
