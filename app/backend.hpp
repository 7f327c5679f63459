// --backend, --gl-device, --gl-debug and --threads: the device that executes the passes.
#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "pipeline/gpu/shader.hpp"

namespace caustics {
class Device;
class GlDevice;
}  // namespace caustics

namespace caustics::app {

class Parser;

enum class Backend : std::uint8_t { Software, OpenGl };

struct BackendRequest {
  Backend backend = Backend::Software;
  int gl_device = -1;               // of `caustics doctor`; -1: the first that works
  int threads = 0;                  // of the software device; 0: one for each core that the process may use
  std::optional<Lanes> lanes = {};  // likewise; none: as SoftwareOptions has it
  // Of the OpenGL device (GlOptions); the software device measures always, and compiles nothing.
  bool measure = false, debug = false;
  std::function<void(std::string_view shader)> compiling = {};
};

// The options; they write into `request`, which must outlive the parser. With `several`, --backend may
// stand several times or be `both`, and goes there, each backend once; with `thread_counts`, --threads is a
// list and goes there.
void add_backend_options(Parser& parser, BackendRequest& request, std::vector<Backend>* several = nullptr,
                         std::vector<int>* thread_counts = nullptr);
// --threads alone.
void add_threads_option(Parser& parser, int& threads);

// Throws Error (BackendUnavailable) where there is no such device.
std::unique_ptr<Device> make_device(const BackendRequest& request);
// The OpenGL device of a request, whatever its backend. Says on stderr, once, which devices could not be used
// before it, and why.
std::unique_ptr<GlDevice> make_gl_device(const BackendRequest& request);

}  // namespace caustics::app
