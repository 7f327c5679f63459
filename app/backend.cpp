#include "app/backend.hpp"

#include <algorithm>

#include "gl_backend/gl_device.hpp"
#include "pipeline/gpu/error.hpp"
#include "raster/software_device.hpp"

namespace caustics::app {

namespace {

Backend parse_backend(const std::string& name) {
  if (name == "software") return Backend::Software;
  if (name == "gl") return Backend::OpenGl;
  throw Error(ExitCode::WrongUsage,
              "--backend cannot be '" + name.substr(0, 60) + "': software or gl");
}

void add_one(std::vector<Backend>& backends, Backend backend) {
  if (std::find(backends.begin(), backends.end(), backend) == backends.end()) backends.push_back(backend);
}

void add_several(std::vector<Backend>& backends, const std::string& value) {
  if (value != "both") return add_one(backends, parse_backend(value));
  add_one(backends, Backend::Software);
  add_one(backends, Backend::OpenGl);
}

}  // namespace

void add_backend_options(Parser& parser, BackendRequest& request, std::vector<Backend>* several) {
  if (several) {
    parser.repeated("--backend", "NAME",
                    {"what executes the passes; may stand several times", "software|gl|both", "software"},
                    [several](const std::string& value) { add_several(*several, value); });
  } else {
    parser.option("--backend", "NAME",
                  {"what executes the passes, gl by OpenGL 4.5; both draw the same", "software|gl", "software"},
                  [&](const std::string& value) { request.backend = parse_backend(value); });
  }
  parser.number("--gl-device", "N",
                {"the OpenGL device, as 'caustics doctor' numbers them", "", "the first that works"},
                Limits<int>{0, 1023}, request.gl_device);
  add_threads_option(parser, request.threads);
}

void add_threads_option(Parser& parser, int& threads) {
  parser.number("-t,--threads", "N", {"change the time, never a bit of the result", "", "one a core"},
                Limits<int>{1, 1024}, threads);
}

std::unique_ptr<Device> make_device(const BackendRequest& request) {
  if (request.backend == Backend::OpenGl) return make_gl_device({.device = request.gl_device});
  return make_software_device({.threads = request.threads});
}

}  // namespace caustics::app
