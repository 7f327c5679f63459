// What the fuzzers share: bytes read as a scene file under tight limits, what must hold of every scene that
// is read, and a whole tiny frame of it.
#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "pipeline/gpu/error.hpp"
#include "pipeline/scene/animated_scene.hpp"
#include "pipeline/scene/gltf/load_gltf.hpp"
#include "pipeline/settings/settings.hpp"

namespace caustics::fuzz {

using ByteSpan = std::span<const std::uint8_t>;

// Says what does not hold on stderr, and ends the program by a signal, so that the input is kept.
[[noreturn]] void finding(const std::string& what);

// A finding unless the error is of ExitCode::BadInput and its message one printable line.
void check_refusal(const Error& error);

// Limits under which a run takes milliseconds; each is reached by some file of the corpus.
LoadOptions small_limits();

// The scene in the bytes, or in a file: nothing when it is refused, as check_refusal allows. Bytes are put
// into a folder of their own, beside files that they may name: side.bin, side.png, folder/side.bin. `why`
// receives the refusal.
std::optional<AnimatedScene> load_bytes(ByteSpan bytes, const LoadOptions& limits);
std::optional<AnimatedScene> load_path(const std::filesystem::path& path, const LoadOptions& limits,
                                       std::string* why = nullptr);

// The scene at a moment; nothing when the animation takes it beyond the limits.
std::optional<Scene> scene_at(const AnimatedScene& animated, double seconds);

// A finding unless positions, normals, lights, cameras and texels are finite, normals and directions of
// length 1, and indices within what they refer to.
void check_sound(const Scene& scene);

// How a fuzzed frame is drawn, from the last bytes of an input; any bytes give settings that may be used.
inline constexpr std::size_t kSettingsBytes = 8;
struct FrameChoice {
  Settings settings;
  double moment = 0.0;  // 0..1, of the animation
};
FrameChoice choice_of(ByteSpan last);

// Renders a frame of the scene on the software device, every pass that it calls for. A finding when an
// attachment has a value that is not finite, or when the light of a ledger is not accounted for. False when
// the settings or the scene's size do not allow for it.
bool render_frame(Scene scene, const Settings& settings, double seconds);

}  // namespace caustics::fuzz
