Medium medium;
