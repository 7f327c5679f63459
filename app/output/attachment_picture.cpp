#include "app/output/attachment_picture.hpp"

#include <algorithm>
#include <cmath>

#include "app/output/attachment_kind.hpp"
#include "app/output/color_scale.hpp"
#include "app/output/status_colors.hpp"
#include "pipeline/gpu/text.hpp"

namespace caustics::app {

namespace {

// Distances from here on stand for "there is nothing", metres.
constexpr float kNowhere = 1e30f;

// One texel of an attachment.
struct Texel {
  const Attachment& attachment;
  int x, y;

  int channels() const { return attachment.image.channels(); }
  float operator[](int channel) const { return attachment.image.at(x, y, channel); }
  bool is_finite() const {
    for (int c = 0; c < channels(); ++c)
      if (!std::isfinite((*this)[c])) return false;
    return true;
  }
  bool is_cleared() const {
    for (int c = 0; c < channels(); ++c)
      if ((*this)[c] != attachment.clear[static_cast<std::size_t>(c)]) return false;
    return true;
  }
  // Of the colour channels.
  double largest() const {
    double value = 0.0;
    for (int c = 0; c < std::min(channels(), 3); ++c)
      value = std::max(value, std::abs(static_cast<double>((*this)[c])));
    return value;
  }
};

template <class Use>
void for_each_texel(const Attachment& attachment, const Use& use) {
  for (int y = 0; y < attachment.image.height(); ++y)
    for (int x = 0; x < attachment.image.width(); ++x) use(Texel{attachment, x, y});
}

struct Range {
  double least = 0.0, most = 0.0;
  double noise = 0.0;  // a range that is no wider is one value, and its roundings

  bool is_one_value() const { return most - least <= noise; }
  // 0..1, values beyond cut off; the middle of one value.
  double level(double value) const {
    return is_one_value() ? 0.5 : std::clamp((value - least) / (most - least), 0.0, 1.0);
  }
  std::string text() const {
    return significant(least, 4) + (is_one_value() ? "" : " to " + significant(most, 4));
  }
};

// What colours span, and how a caption says it.
struct Scale {
  Range range;
  std::string text = "nothing";
};

// The finite values of a channel where something was drawn, sorted.
std::vector<double> drawn_values(const Attachment& attachment, int channel) {
  std::vector<double> values;
  for_each_texel(attachment, [&](const Texel& texel) {
    const float value = texel[channel];
    if (std::isfinite(value) && std::abs(value) < kNowhere && !texel.is_cleared())
      values.push_back(static_cast<double>(value));
  });
  std::sort(values.begin(), values.end());
  return values;
}

// Of each of the first channels: from the least to the most, or where few stray far from the others, what
// 98 % of them span. Coordinates are rounded as finely as the largest of them.
std::vector<Scale> scales_of(const Attachment& attachment, int channels) {
  std::vector<std::vector<double>> values;
  double noise = 0.0;
  for (int c = 0; c < channels; ++c) {
    values.push_back(drawn_values(attachment, c));
    if (values.back().empty()) return std::vector<Scale>(static_cast<std::size_t>(channels));
    noise = std::max({noise, 2e-6 * std::abs(values.back().front()), 2e-6 * std::abs(values.back().back())});
  }
  std::vector<Scale> scales;
  for (const std::vector<double>& sorted : values) {
    const std::size_t stray = sorted.size() / 100;
    const Range all{sorted.front(), sorted.back(), noise};
    const Range most{sorted[stray], sorted[sorted.size() - 1 - stray], noise};
    if (most.is_one_value() || most.most - most.least > 0.5 * (all.most - all.least))
      scales.push_back({all, all.text()});
    else
      scales.push_back({most, most.text() + " (98 % of " + all.text() + ")"});
  }
  return scales;
}

double largest_in(const Attachment& attachment) {
  double largest = 0.0;
  for_each_texel(attachment, [&](const Texel& texel) {
    if (texel.is_finite()) largest = std::max(largest, texel.largest());
  });
  return largest;
}

// That 99 % of the texels with light do not exceed; 1 where there is none.
double nearly_largest_in(const Attachment& attachment) {
  std::vector<double> lit;
  for_each_texel(attachment, [&](const Texel& texel) {
    if (texel.is_finite() && texel.largest() > 0.0) lit.push_back(texel.largest());
  });
  if (lit.empty()) return 1.0;
  const auto nth = lit.begin() + static_cast<std::ptrdiff_t>(lit.size() - lit.size() / 100 - 1);
  std::nth_element(lit.begin(), nth, lit.end());
  return *nth;
}

// Squares of two dark greys.
Color chequer(int x, int y) {
  const double grey = (x / 8 + y / 8) % 2 == 0 ? 0.22 : 0.28;
  return {grey, grey, grey};
}

// IEC 61966-2-1.
double srgb_encoded(double linear) {
  const double x = std::clamp(linear, 0.0, 1.0);
  return x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1.0 / 2.4) - 0.055;
}

enum class Cleared : std::uint8_t { Chequered, Shown };

// Every texel by `shade`, but for those that are not finite and, if asked for, those as they were cleared.
template <class Shade>
Image painted(const Attachment& attachment, Cleared cleared, const Shade& shade) {
  Image picture(Format::RGBA32F, attachment.image.width(), attachment.image.height());
  for_each_texel(attachment, [&](const Texel& texel) {
    Color color = kFaultColor;
    if (texel.is_finite())
      color = cleared == Cleared::Chequered && texel.is_cleared() ? chequer(texel.x, texel.y) : shade(texel);
    picture.at(texel.x, texel.y, 0) = static_cast<float>(color.r);
    picture.at(texel.x, texel.y, 1) = static_cast<float>(color.g);
    picture.at(texel.x, texel.y, 2) = static_cast<float>(color.b);
  });
  return picture;
}

// A colour from each of the first three channels; two channels have no blue.
template <class Level>
Color color_by_channel(const Texel& texel, const Level& level) {
  const int channels = texel.channels();
  return {level(0), channels > 1 ? level(1) : level(0),
          channels > 2   ? level(2)
          : channels > 1 ? 0.0
                         : level(0)};
}

// By a scale from black to white.
AttachmentPicture by_brightness(const Attachment& attachment) {
  const Scale scale = scales_of(attachment, 1).front();
  return {"",
          painted(attachment, Cleared::Chequered,
                  [&](const Texel& texel) {
                    if (!(std::abs(texel[0]) < kNowhere)) return chequer(texel.x, texel.y);
                    return cubehelix(0.1 + 0.9 * scale.range.level(static_cast<double>(texel[0])));
                  }),
          scale.text + (scale.range.is_one_value() ? " everywhere" : ", from dark to bright")};
}

// Two or three channels as red, green and blue, each over its own range. The colours are pale, so that none
// looks like what is not finite.
AttachmentPicture by_colors(const Attachment& attachment, int channels) {
  constexpr const char* kNamesOfColors[] = {"red", "green", "blue"};
  const std::vector<Scale> scales = scales_of(attachment, channels);
  std::string text;
  for (int c = 0; c < channels; ++c) {
    text += (c == 0 ? "" : ", ") + std::string(kNamesOfColors[c]) + " is " + "xyz"[c] + " " +
            scales[static_cast<std::size_t>(c)].text;
  }
  const auto level = [&](const Texel& texel, int c) {
    if (c >= channels) return 0.3;
    return 0.3 + 0.65 * scales[static_cast<std::size_t>(c)].range.level(static_cast<double>(texel[c]));
  };
  return {"",
          painted(attachment, Cleared::Chequered,
                  [&](const Texel& texel) {
                    return Color{level(texel, 0), level(texel, 1), level(texel, 2)};
                  }),
          text};
}

// The least light there is, within what a logarithmic scale shows.
double least_in(const Attachment& attachment, double largest) {
  double least = largest;
  for_each_texel(attachment, [&](const Texel& texel) {
    if (texel.is_finite() && texel.largest() > 0.0) least = std::min(least, texel.largest());
  });
  return std::max(least, darkest_of(largest));
}

AttachmentPicture flux_picture(const Attachment& attachment) {
  const double largest = largest_in(attachment), least = least_in(attachment, largest);
  return {"",
          painted(attachment, Cleared::Shown,
                  [&](const Texel& texel) { return logarithmic_color(texel.largest(), least, largest); }),
          largest == 0.0 ? "0 everywhere"
                         : "largest channel, logarithmic from " + significant(least, 4) +
                               (least > darkest_of(largest) ? "" : " and less") + ", dark, to " +
                               significant(largest, 4) + ", white; black is 0"};
}

AttachmentPicture radiance_picture(const Attachment& attachment) {
  const double white = nearly_largest_in(attachment), most = largest_in(attachment);
  return {"",
          painted(attachment, Cleared::Shown,
                  [&](const Texel& texel) {
                    return color_by_channel(
                        texel, [&](int c) { return srgb_encoded(static_cast<double>(texel[c]) / white); });
                  }),
          most == 0.0 ? "0 everywhere"
                      : "sRGB; full brightness is " + significant(white, 4) +
                            ", the 99th percentile of what is lit; at most " + significant(most, 4)};
}

AttachmentPicture shares_picture(const Attachment& attachment, bool encoded) {
  return {"",
          painted(attachment, Cleared::Chequered,
                  [&](const Texel& texel) {
                    return color_by_channel(texel, [&](int c) {
                      const auto value = static_cast<double>(texel[c]);
                      return encoded ? std::clamp(value, 0.0, 1.0) : srgb_encoded(value);
                    });
                  }),
          encoded ? "0 to 1, as stored" : "0 to 1, linear, shown as sRGB"};
}

AttachmentPicture normal_picture(const Attachment& attachment) {
  return {"",
          painted(attachment, Cleared::Chequered,
                  [&](const Texel& texel) {
                    return color_by_channel(texel, [&](int c) {
                      return std::clamp(0.5 + 0.5 * static_cast<double>(texel[c]), 0.0, 1.0);
                    });
                  }),
          "red, green, blue are 0.5 + 0.5 x, y, z: -1 to 1"};
}

// The status that a texel holds; Empty for a number that is none.
LandingStatus status_at(const Texel& texel, int channel) {
  const float value = texel[channel];
  return value >= 0.0f && value < static_cast<float>(kLandingStatuses) ? static_cast<LandingStatus>(value)
                                                                       : LandingStatus::Empty;
}

AttachmentPicture status_picture(const Attachment& attachment, int channel) {
  std::array<std::uint64_t, kLandingStatuses> counts{};
  for_each_texel(attachment, [&](const Texel& texel) {
    if (texel.is_finite()) ++counts[static_cast<std::size_t>(status_at(texel, channel))];
  });
  std::string text;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    if (counts[i] == 0) continue;
    const auto status = static_cast<LandingStatus>(i);
    text += (text.empty() ? "" : ", ") + std::string(name_of(status)) + " " + grouped(counts[i]) + " (" +
            std::string(color_of(status).name) + ")";
  }
  return {"status",
          painted(attachment, Cleared::Shown,
                  [&](const Texel& texel) { return color_of(status_at(texel, channel)).color; }),
          text};
}

AttachmentPicture first_picture(const Attachment& attachment, AttachmentKind kind) {
  const int channels = attachment.image.channels();
  switch (kind) {
    case AttachmentKind::Normal:
      return normal_picture(attachment);
    case AttachmentKind::Flux:
      return flux_picture(attachment);
    case AttachmentKind::Radiance:
      return radiance_picture(attachment);
    case AttachmentKind::Color:
    case AttachmentKind::Display:
      return shares_picture(attachment, kind == AttachmentKind::Display);
    case AttachmentKind::Depth:
      return by_brightness(attachment);
    case AttachmentKind::Position:
    case AttachmentKind::Scalar:
      break;
  }
  return channels == 1 ? by_brightness(attachment) : by_colors(attachment, std::min(channels, 3));
}

std::string faults_text(const Attachment& attachment) {
  std::uint64_t faults = 0;
  for_each_texel(attachment, [&](const Texel& texel) { faults += texel.is_finite() ? 0 : 1; });
  return faults == 0 ? "" : "; " + grouped(faults) + " texels are NaN or infinite (magenta)";
}

}  // namespace

std::vector<AttachmentPicture> pictures_of(const Attachment& attachment) {
  const AttachmentKind kind = kind_of(attachment.texture.format, attachment.meaning);
  const int status = status_channel_of(attachment.meaning);
  std::vector<AttachmentPicture> pictures{first_picture(attachment, kind)};
  pictures.front().caption = std::string(name_of(kind)) + ": " + pictures.front().caption;
  if (status >= 0 && status < attachment.image.channels()) {
    pictures.push_back(status_picture(attachment, status));
    pictures.back().caption = "status: " + pictures.back().caption;
  }
  for (AttachmentPicture& picture : pictures) picture.caption += faults_text(attachment);
  return pictures;
}

}  // namespace caustics::app
