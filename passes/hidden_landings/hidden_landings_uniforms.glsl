View receiver;  // of the maps of receivers
