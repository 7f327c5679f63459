// Looks at a picture's caustics while it is drawn, when the light on what the camera sees is known.
#pragma once
#include <optional>

#include "app/frame.hpp"
#include "pipeline/measure/seen_caustic.hpp"

namespace caustics::app {

class CausticSight {
 public:
  // To be called after each pass. Of several samples of a pixel it looks at the first.
  void look(const RenderedFrame& frame, const PlannedPass& pass);
  // None before a look, and of frames without caustics.
  const std::optional<SeenCaustic>& seen() const { return seen_; }
  // What looking took.
  double milliseconds() const { return milliseconds_; }

 private:
  std::optional<SeenCaustic> seen_;
  double milliseconds_ = 0.0;
};

}  // namespace caustics::app
