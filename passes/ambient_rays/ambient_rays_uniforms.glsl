int most_steps;      // as next_surface has them
int first_receiver;
float touch;
float reach;         // metres, from where on a surface keeps nothing from another
