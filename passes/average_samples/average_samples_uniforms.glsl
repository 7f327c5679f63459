float weight;  // of a sample: 1 over their number
