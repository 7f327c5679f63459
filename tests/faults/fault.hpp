// Put into the planted copy of the sources (plant.py), never into the product: which fault runs.
#pragma once
#include <string>

// The number of the fault that the variable CAUSTICS_FAULT names; 0 without one.
extern "C" int caustics_fault;

#define FAULT(number) (caustics_fault == number)

// The same choice for OpenGL's texts.
inline std::string fault_text() {
  return "#define FAULT(number) (number == " + std::to_string(caustics_fault) + ")\n";
}
