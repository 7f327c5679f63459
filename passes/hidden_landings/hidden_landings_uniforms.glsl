View caustic;  // the light's map that the landings are laid into
