// caustics doctor: what this build is made of and what this machine lets it use.
#include <CLI/Version.hpp>
#include <cstdio>
#include <functional>
#include <glm/glm.hpp>
#include <nlohmann/json.hpp>
#include <thread>

#include "app/shell/parser.hpp"
#include "app/shell/version.hpp"
#include "gl_backend/gl_probe.hpp"
#include "lab/reference/tracer/rays.hpp"
#include "passes/registry.hpp"
#include "pipeline/gpu/device.hpp"
#include "pipeline/gpu/error.hpp"
#include "pipeline/gpu/shader.hpp"
#include "pipeline/gpu/text.hpp"
#include "pipeline/image_io/image_io.hpp"
#include "pipeline/scene/gltf/compressed.hpp"
#include "raster/software_device.hpp"

namespace caustics::app {

namespace {

void line(const char* what, const std::string& value) {
  std::printf("%-22s %s\n", what, one_line(value).c_str());
}

// Of a part that is loaded when it is needed, and may be missing: then the line says so, and the others
// follow.
void line_on_demand(const char* what, const std::function<std::string()>& value) {
  try {
    line(what, value());
  } catch (const Error& error) {
    line(what, std::string("cannot be used: ") + error.what());
  }
}

std::string instruction_sets(const std::vector<Lanes>& lanes) {
  std::string text;
  for (const Lanes l : lanes) text += (text.empty() ? "" : ", ") + std::string(lanes_name(l));
  return text;
}

std::vector<Lanes> compiled_lanes() {
  std::vector<Lanes> lanes;
  const ShaderKernels& kernels = pass_registry().front().shaders.front().shader->kernels;
  for (int l = 0; l < kLanesCount; ++l) {
    if (kernels.vertex[static_cast<std::size_t>(l)]) lanes.push_back(static_cast<Lanes>(l));
  }
  return lanes;
}

// Whether attributes are interpolated with fused multiply-add instructions: the result is
// the same either way, only slower without.
std::string fused_multiply_add() {
#if defined(__x86_64__) || defined(__i386__)
  return __builtin_cpu_supports("fma") ? "yes" : "no: computed in software, slower";
#else
  return "as this architecture has it";
#endif
}

// What the first device that works makes of arithmetic and shapes, and its class.
void describe_driver() {
  const auto device = caustics::make_gl_device();
  const GlFindings found = probe(*device);
  line("gl driver class", std::string(name_of(class_of(found))));
  for (const auto& [what, value] : rows_of(found)) line(("  " + what).c_str(), value);
}

// Every way to OpenGL that EGL offers, or why there is none.
void describe_gl() {
  try {
    for (const GlDeviceInfo& gl : list_gl_devices()) {
      const std::string found = gl.reason.empty() ? gl.renderer + ", " + gl.vendor + ", OpenGL " + gl.version
                                                  : "cannot be used: " + gl.reason;
      line(("gl backend " + std::to_string(gl.index)).c_str(), gl.platform + ": " + found);
    }
    describe_driver();
  } catch (const Error& error) {
    line("gl backend", error.what());
  }
}

std::string unpacked_formats() {
  const bool draco = gltf::has_draco_decoder(), meshopt = gltf::has_meshopt_decoder();
  if (!draco && !meshopt) return "nothing: neither Draco nor meshoptimizer in this build";
  return draco && meshopt ? "Draco, meshopt" : draco ? "Draco" : "meshopt";
}

}  // namespace

ExitCode run_doctor(const Arguments& arguments) {
  Parser parser("doctor", "Says what this build is made of and what this machine lets it use.",
                "  caustics doctor\n");
  if (!parser.parse(arguments)) return ExitCode::Done;
  line("version", version());
  line("compiler", compiler());
  line("threads", std::to_string(std::max(1u, std::thread::hardware_concurrency())));
  line("instructions compiled", instruction_sets(compiled_lanes()));
  line("instructions usable", instruction_sets(supported_lanes()));
  line("fused multiply-add", fused_multiply_add());
  const auto device = make_software_device({});
  line("software backend", device->description());
  line("largest texture", std::to_string(device->max_texture_size()));
  describe_gl();
  line("passes", std::to_string(pass_registry().size()));
  line_on_demand("OpenImageIO", [] { return image_io().version; });
  line("unpacks from glTF", unpacked_formats());
  line("CLI11", CLI11_VERSION);
  line("nlohmann-json", std::to_string(NLOHMANN_JSON_VERSION_MAJOR) + "." +
                            std::to_string(NLOHMANN_JSON_VERSION_MINOR) + "." +
                            std::to_string(NLOHMANN_JSON_VERSION_PATCH));
  line("GLM", std::to_string(GLM_VERSION_MAJOR) + "." + std::to_string(GLM_VERSION_MINOR) + "." +
                  std::to_string(GLM_VERSION_PATCH) + "." + std::to_string(GLM_VERSION_REVISION));
  line("Embree", tracer::has_ray_queries() ? tracer::ray_queries_version()
                                           : "not in this build: no 'caustics reference'");
#if defined(CAUSTICS_TBB_VERSION)
  line("oneTBB", CAUSTICS_TBB_VERSION);
#else
  line("oneTBB", "not in this build: one thread");
#endif
  return ExitCode::Done;
}

}  // namespace caustics::app
