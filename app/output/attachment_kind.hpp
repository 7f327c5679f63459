// What kind of thing an attachment holds, judged by its format and by what its pass says of a texel: how it
// is to be shown follows from that.
#pragma once
#include <cstdint>
#include <string_view>

#include "pipeline/gpu/format.hpp"

namespace caustics::app {

enum class AttachmentKind : std::uint8_t {
  Position,  // places, in metres or texels
  Normal,    // unit vectors
  Flux,      // light, over many powers of ten
  Depth,     // window depth, or a distance in metres
  Radiance,  // nit, or irradiance in lux
  Color,     // shares of light by channel, 0..1, linear
  Display,   // encoded for a screen
  Scalar     // numbers of any other kind
};
std::string_view name_of(AttachmentKind kind);

// `meaning`: as PassDefinition has it for the attachment.
AttachmentKind kind_of(Format format, std::string_view meaning);

// The channel that holds a LandingStatus (pipeline/measure/ledger.hpp has their names); -1: none does.
int status_channel_of(std::string_view meaning);

}  // namespace caustics::app
