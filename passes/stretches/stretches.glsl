// The stretches of light's way that the air shows: the walk once more. stretches.md explains.
#define HAZE 1
#define STRETCHES 1
#include "passes/walk/walk.glsl"
