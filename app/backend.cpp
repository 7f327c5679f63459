#include "app/backend.hpp"

#include <algorithm>
#include <set>

#include "app/shell/parser.hpp"
#include "app/shell/terminal.hpp"
#include "gl_backend/gl_device.hpp"
#include "pipeline/gpu/error.hpp"
#include "raster/software_device.hpp"

namespace caustics::app {

namespace {

Backend parse_backend(const std::string& name) {
  if (name == "software") return Backend::Software;
  if (name == "gl") return Backend::OpenGl;
  throw Error(ExitCode::WrongUsage, "--backend cannot be " + in_quotes(name) + ": software or gl");
}

void add_one(std::vector<Backend>& backends, Backend backend) {
  if (std::find(backends.begin(), backends.end(), backend) == backends.end()) backends.push_back(backend);
}

void add_several(std::vector<Backend>& backends, const std::string& value) {
  if (value != "both") return add_one(backends, parse_backend(value));
  add_one(backends, Backend::Software);
  add_one(backends, Backend::OpenGl);
}

constexpr Limits<int> kThreads{1, 1024};

std::vector<int> parse_thread_counts(const std::string& list) {
  std::vector<int> counts;
  for (std::size_t start = 0; start <= list.size();) {
    const std::size_t end = std::min(list.find(',', start), list.size());
    counts.push_back(parse_number("--threads", list.substr(start, end - start), kThreads));
    start = end + 1;
  }
  return counts;
}

}  // namespace

void add_backend_options(Parser& parser, BackendRequest& request, std::vector<Backend>* several,
                         std::vector<int>* thread_counts) {
  if (several) {
    parser.repeated("--backend", "NAME",
                    {"what executes the passes; may stand several times", "software|gl|both", "software"},
                    [several](const std::string& value) { add_several(*several, value); });
  } else {
    parser.option(
        "--backend", "NAME",
        {"what executes the passes, gl by OpenGL 4.5; both draw the same", "software|gl", "software"},
        [&](const std::string& value) { request.backend = parse_backend(value); });
  }
  parser.number("--gl-device", "N",
                {"the OpenGL device, as 'caustics doctor' numbers them", "", "the first that works"},
                Limits<int>{0, 1023}, request.gl_device);
  parser.flag("--gl-debug", request.debug, "an OpenGL debug context: errors name the faulty call");
  if (!thread_counts) return add_threads_option(parser, request.threads);
  parser.option("-t,--threads", "N,M",
                {"measured in turn; llvmpipe has as many", text_of(kThreads), "one a core"},
                [=](const std::string& list) { *thread_counts = parse_thread_counts(list); });
}

void add_threads_option(Parser& parser, int& threads) {
  parser.number("-t,--threads", "N", {"change the time, never a bit of the result", "", "one a core"},
                kThreads, threads);
}

std::unique_ptr<GlDevice> make_gl_device(const BackendRequest& request) {
  std::unique_ptr<GlDevice> device = caustics::make_gl_device({.device = request.gl_device,
                                                               .measure = request.measure,
                                                               .debug = request.debug,
                                                               .compiling = request.compiling});
  static std::set<std::string> told;  // a study makes many devices
  if (!device->passed_over().empty() && told.insert(device->passed_over()).second) {
    complain("OpenGL runs on " + device->description() +
             ", because others cannot be used: " + device->passed_over());
  }
  return device;
}

std::unique_ptr<Device> make_device(const BackendRequest& request) {
  if (request.backend == Backend::OpenGl) return make_gl_device(request);
  return make_software_device({.threads = request.threads, .lanes = request.lanes});
}

}  // namespace caustics::app
