// What a scene is set up with beside what its file holds: ground, sun and view, as a person asks for them.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace caustics {

struct Ground {
  enum class Wish : std::uint8_t { Auto, On, Off, At };
  Wish wish = Wish::Auto;
  float height = 0.0f;  // of At: y in the file's world, metres
};

// Where something stands, seen from the scene. Degrees.
struct Bearing {
  float azimuth = 0.0f;     // from +z towards +x, -360..360
  float elevation = 45.0f;  // above the horizon, -90..90
};

struct SunWish {
  Bearing stands;
  std::optional<float> lux{};  // 0..1e9; none: as an added sun
};

// As text, which `parse` reads back as the same. "auto" stands for no sun or view that is asked for.
std::string text_of(const Ground& ground);
std::string text_of(const std::optional<SunWish>& sun);
std::string text_of(const std::optional<Bearing>& view);
// False, and nothing is changed, where the text is no such value.
bool parse(std::string_view text, Ground& ground);
bool parse(std::string_view text, std::optional<SunWish>& sun);
bool parse(std::string_view text, std::optional<Bearing>& view);

}  // namespace caustics
