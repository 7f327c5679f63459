#include "app/numeric_faults.hpp"

#include <cmath>

#include "app/frame.hpp"
#include "app/shell/terminal.hpp"
#include "pipeline/gpu/error.hpp"
#include "pipeline/measure/brightness_bound.hpp"

namespace caustics::app {

namespace {

// A channel of a pixel; rows from the bottom.
struct Value {
  int x = 0, y = 0, channel = 0;
  float value = 0.0f;
};

// The first that is not finite, or else the brightest of colours.
Value worst_of(const ImageView& image) {
  Value worst;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      for (int c = 0; c < image.channels(); ++c) {
        const float value = image.at(x, y, c);
        if (!std::isfinite(value)) return {x, y, c, value};
        if (c < 3 && std::fabs(value) > std::fabs(worst.value)) worst = {x, y, c, value};
      }
    }
  }
  return worst;
}

// Infinite for images of no light.
double bound_of(const RenderedFrame& frame, const std::string& texture, BoundBy by) {
  const BrightnessBound bound =
      brightness_bound(frame.scene(), frame.effects(), frame.settings(), frame.views(), by);
  if (texture == "beauty") return bound.radiance;
  if (texture == "aov_direct") return bound.direct;
  if (texture == "aov_caustic") return bound.caustic;
  return std::numeric_limits<double>::infinity();
}

[[noreturn]] void refuse(const Value& worst, int height, const std::string& what, const std::string& why) {
  throw Error(ExitCode::NumericFault, what + " is " + significant(static_cast<double>(worst.value), 3) +
                                          " at pixel " + std::to_string(worst.x) + "," +
                                          std::to_string(height - 1 - worst.y) +
                                          " from the top left, channel " + "RGBA"[worst.channel] + why +
                                          "; no picture is written, --dump DIR shows every pass");
}

}  // namespace

void refuse_numeric_faults(const RenderedFrame& frame, const std::string& texture, const std::string& which) {
  const ImageView image = frame.look_at(texture);
  const Value worst = worst_of(image);
  if (!std::isfinite(worst.value)) refuse(worst, image.height(), which + texture, "");
  const double value = std::fabs(static_cast<double>(worst.value));
  if (value <= bound_of(frame, texture, BoundBy::Guess)) return;
  const double most = bound_of(frame, texture, BoundBy::Triangles);
  if (value > most)
    refuse(worst, image.height(), which + texture,
           ", but the scene's lights can give no more than " + significant(most, 3));
}

}  // namespace caustics::app
