// Runs the pass by itself on both devices, with numbers that a person can compute.
#include <cstdio>
#include <memory>

#include "gl_backend/gl_device.hpp"
#include "luminance/luminance.hpp"
#include "pipeline/gpu/error.hpp"
#include "pipeline/renderer/run_pass.hpp"
#include "raster/software_device.hpp"

using namespace caustics;

namespace {

bool test(Device& device) {
  Image picture(Format::RGBA32F, 2, 1);
  picture.values = {1.0f, 0.0f, 0.0f, 1.0f, 0.0f, 2.0f, 0.0f, 1.0f};  // red, and green twice as bright
  const Pass pass = luminance_pass();
  const PassImages out =
      run_pass(device, definition_of(pass),
               {.width = 2, .height = 1, .uniforms = pass.uniforms({}), .textures = {picture}});
  const bool good = out["luminance"].values == std::vector<float>{0.2126f, 1.4304f};
  std::printf("%s: %s\n", device.description().c_str(), good ? "passed" : "FAILED");
  return good;
}

}  // namespace

int main() {
  bool good = test(*make_software_device());
  try {
    good = test(*make_gl_device()) && good;
  } catch (const Error& error) {
    std::printf("skipped: %s\n", error.what());
  }
  return good ? 0 : 1;
}
