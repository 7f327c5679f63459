// A pass of one's own: the luminance of a picture.
#pragma once
#include "pipeline/plan/pass.hpp"

caustics::Pass luminance_pass();
