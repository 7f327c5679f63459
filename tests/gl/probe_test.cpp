// The start-up probe: what it finds on this machine's driver, on drivers that compute otherwise, and the
// class that follows.
#include "gl_backend/gl_probe.hpp"

#include <cmath>
#include <functional>

#include "tests/gl/gl_or_skip.hpp"
#include "tests/support/forwarding_device.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

const GlLimits kLimits{.subpixel_bits = 8, .smallest_point = 1.0f, .largest_point = 255.0f};

// A driver whose results are changed as they are read.
class OtherDriver final : public ForwardingDevice {
 public:
  using Change = std::function<void(Image& results, const Image& operands)>;
  OtherDriver(std::unique_ptr<Device> device, Change change)
      : ForwardingDevice(std::move(device)), change_(std::move(change)) {}
  TextureId upload(const Image& image) override {
    operands_ = image;
    return ForwardingDevice::upload(image);
  }
  PassResult run(const PassRun& run) override {
    calculates_ = !run.definition->reads.empty();
    return ForwardingDevice::run(run);
  }
  Image read_back(TextureId texture) override {
    Image image = ForwardingDevice::read_back(texture);
    if (calculates_ && image.height() > 1) change_(image, operands_);
    return image;
  }

 private:
  Change change_;
  Image operands_;
  bool calculates_ = false;
};

GlFindings probed(const OtherDriver::Change& change) {
  OtherDriver driver(gl_or_skip(), change);
  return probe(driver, "a GPU", kLimits);
}

}  // namespace

TEST_CASE("probe: llvmpipe divides, takes roots and adds as IEEE 754 rounds, and is known by how it draws") {
  const auto gl = gl_or_skip();
  const GlFindings found = probe(*gl);
  CHECK(found.drawn_subpixel_bits >= 4);
  CHECK(rows_of(found).size() == 11);
  if (found.renderer.find("llvmpipe") == std::string::npos) return;
  CHECK(found.wrong_quotients + found.wrong_roots + found.wrong_sums == 0);
  CHECK(found.makes_nan);
  CHECK(found.drawn_subpixel_bits == 8);
  CHECK(found.interpolated != Interpolated::Otherwise);
  CHECK(class_of(found) < DriverClass::Hardware);
}

TEST_CASE("probe: it makes two programs and leaves no texture and no mesh") {
  const auto gl = gl_or_skip();
  probe(*gl);
  const DeviceObjects first = gl->made();
  CHECK(first.programs <= 3);  // points drawn as quadrilaterals have one of their own
  probe(*gl);
  CHECK(gl->made().programs == first.programs);
}

TEST_CASE("probe: quotients that are an ulp off are counted, and make a driver hardware") {
  gl_or_skip();
  const GlFindings found = probed([](Image& results, const Image& operands) {
    for (std::size_t i = 0; i < results.values.size(); i += 4)
      results.values[i] = operands.values[i] * (1.0f / operands.values[i + 1]);
  });
  CHECK(found.wrong_quotients > GlFindings::kOperands / 10);
  CHECK(found.wrong_quotients < GlFindings::kOperands / 2);
  CHECK(found.wrong_roots + found.wrong_sums == 0);
  CHECK(class_of(found) == DriverClass::Hardware);
}

TEST_CASE("probe: products plus sums that round once are found contracted") {
  gl_or_skip();
  const GlFindings found = probed([](Image& results, const Image& operands) {
    for (std::size_t i = 0; i < results.values.size(); i += 4)
      results.values[i + 2] = results.values[i + 3] =
          std::fma(operands.values[i], operands.values[i + 1], operands.values[i + 2]);
  });
  CHECK(found.contracted_sums > GlFindings::kOperands / 100);
  CHECK(found.contracted_sums == found.wrong_sums);
  CHECK(found.fuses_fma);
  CHECK(class_of(found) == DriverClass::ContractingHardware);
}

TEST_CASE("probe: the class follows from what was found, not from what the driver says") {
  GlFindings found{.renderer = "llvmpipe (LLVM 15.0.6, 256 bits)"};
  CHECK(class_of(found) == DriverClass::LlvmpipeFused);
  found.subpixel_bits = 4;
  CHECK(class_of(found) == DriverClass::LlvmpipeFused);
  found.draws_points_off_target = true;
  CHECK(class_of(found) == DriverClass::LlvmpipeOtherPoints);
  found.draws_points_off_target = false;
  found.misplaced_points = 1;
  CHECK(class_of(found) == DriverClass::LlvmpipeOtherPoints);
  found.interpolated = Interpolated::Unfused;
  CHECK(class_of(found) == DriverClass::LlvmpipeUnfused);
  found.interpolated = Interpolated::Otherwise;
  CHECK(class_of(found) == DriverClass::Hardware);
  found.contracted_sums = 1;
  CHECK(class_of(found) == DriverClass::ContractingHardware);
  found.drawn_subpixel_bits = 4;
  CHECK(class_of(found) == DriverClass::FourSubpixelBits);
  // Whoever draws as llvmpipe does and is not llvmpipe may do the rest otherwise.
  CHECK(class_of({.renderer = "a GPU"}) == DriverClass::Hardware);
  CHECK(class_of({.renderer = "llvmpipe", .wrong_roots = 1}) == DriverClass::Hardware);
}
