int most_steps;      // of the search for one surface
int first_receiver;
float touch;
float reach;         // metres, from where on a surface keeps nothing from another
