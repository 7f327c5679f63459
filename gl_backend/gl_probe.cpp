#include "gl_backend/gl_probe.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <vector>

#include "pipeline/gpu/owned.hpp"
#include "pipeline/gpu/point_rule.hpp"

namespace caustics {

namespace {

constexpr int kSide = 256;
static_assert(kSide * kSide == GlFindings::kOperands);

const Shader kArithmetic{
    "probe_arithmetic",
    "TEXTURE(0, operands)\n"
    "#ifdef VERTEX_STAGE\n"
    "void main() {\n"
    "  set_position(Vec4(vertex_id() == 1 ? 3.0f : -1.0f, vertex_id() == 2 ? 3.0f : -1.0f,"
    " 0.5f, 1.0f));\n"
    "}\n"
    "#else\n"
    "OUTPUT(0, Vec4, results)\n"
    "void main() {\n"
    "  Vec4 o = texel_fetch(operands, Int(frag_x()), Int(frag_y()));\n"
    "  Float quotient = o.x / o.y;\n"
    "  Float root = sqrt(abs(o.z));\n"
    "  Float sum = o.x * o.y + o.z;\n"
    "  results = Vec4(quotient, root, sum, fma(o.x, o.y, o.z));\n"
    "}\n"
    "#endif\n",
    {}};

const Shader kGeometry{"probe_geometry",
                       "VARYING_SMOOTH(0, Vec4, carried)\n"
                       "#ifdef VERTEX_STAGE\n"
                       "ATTRIBUTE(0, Vec4, position)\n"
                       "ATTRIBUTE(4, Vec4, value)\n"
                       "ATTRIBUTE(8, Float, size)\n"
                       "void main() {\n"
                       "  carried = value;\n"
                       "  set_position(position);\n"
                       "  set_point_size(size);\n"
                       "}\n"
                       "#else\n"
                       "OUTPUT(0, Vec4, color)\n"
                       "void main() { color = carried; }\n"
                       "#endif\n",
                       {}};

// xorshift32 (Marsaglia 2003).
class Random {
 public:
  std::uint32_t bits() {
    state_ ^= state_ << 13;
    state_ ^= state_ >> 17;
    return state_ ^= state_ << 5;
  }
  // 1 to 2, by 23 bits.
  float mantissa() { return 1.0f + static_cast<float>(bits() >> 9) * 0x1p-23f; }
  // Either sign, magnitudes from 1/16 to 16.
  float operand() {
    const float magnitude = std::ldexp(mantissa(), static_cast<int>(bits() >> 29) - 4);
    return bits() >> 31 ? -magnitude : magnitude;
  }
  float below(int count) { return static_cast<float>(bits() >> 8) * 0x1p-24f * static_cast<float>(count); }

 private:
  std::uint32_t state_ = 0x9e3779b9u;
};

struct ProbeVertex {
  float x = 0, y = 0;  // pixels of a target of kSide squared
  std::array<float, 4> value{1, 0, 0, 0};
  float size = 1;
};

// Draws into an RGBA32F target and reads it.
class Canvas {
 public:
  explicit Canvas(Device& device) : device_(device) {}

  Image calculate(const Image& operands) {
    PassDefinition definition{.name = "probe",
                              .purpose = "what the driver makes of arithmetic",
                              .reads = {{.name = "operands", .meaning = "numbers"}},
                              .writes = {{.name = "results", .meaning = "quotient, root, sum, fma"}},
                              .shader = &kArithmetic};
    const OwnedTexture texture(device_, device_.upload(operands));
    return run(definition, operands.shape, {.vertex_count = 3, .textures = {texture.id()}});
  }

  // Adds up what covers each pixel.
  Image draw(Topology topology, const std::vector<ProbeVertex>& vertices) {
    PassDefinition definition{.name = "probe",
                              .purpose = "what the driver makes of shapes",
                              .writes = {{.name = "color", .meaning = "sum", .blend = kAccumulate}},
                              .topology = topology,
                              .shader = &kGeometry};
    MeshData data;
    data.layout = {{"position", 4}, {"value", 4}, {"size", 1}};
    for (const ProbeVertex& v : vertices) {
      const auto clip = [](float pixels) { return pixels * (2.0f / kSide) - 1.0f; };
      for (const float f :
           {clip(v.x), clip(v.y), 0.5f, 1.0f, v.value[0], v.value[1], v.value[2], v.value[3], v.size})
        data.vertices.push_back(f);
    }
    const OwnedMesh mesh(device_, device_.create_mesh(data));
    return run(definition, {Format::RGBA32F, kSide, kSide}, {.mesh = mesh.id()});
  }

 private:
  Image run(const PassDefinition& definition, const ImageShape& size, const Draw& draw) {
    const OwnedTexture target(device_, device_.create_texture(Format::RGBA32F, size.width, size.height));
    device_.run({.definition = &definition, .colors = {target.id()}, .draws = {draw}});
    return device_.read_back(target.id());
  }

  Device& device_;
};

void probe_arithmetic(Canvas& canvas, GlFindings& found) {
  Random random;
  Image operands(Format::RGBA32F, kSide, kSide);
  for (float& value : operands.values) value = random.operand();
  const Image results = canvas.calculate(operands);
  int wrong_fma = 0;
  for (std::size_t i = 0; i < results.values.size(); i += 4) {
    const float a = operands.values[i], b = operands.values[i + 1], c = operands.values[i + 2];
    const float product = a * b, fused = std::fma(a, b, c), sum = results.values[i + 2];
    found.wrong_quotients += results.values[i] != a / b;
    found.wrong_roots += results.values[i + 1] != std::sqrt(std::fabs(c));
    found.wrong_sums += sum != product + c;
    found.contracted_sums += sum != product + c && sum == fused;
    wrong_fma += results.values[i + 3] != fused;
  }
  found.fuses_fma = wrong_fma == 0;
}

void probe_special_values(Canvas& canvas, GlFindings& found) {
  Image operands(Format::RGBA32F, 2, 1);
  operands.values = {0x1p-80f, 0x1p60f, 0, 0, 0, 0, std::numeric_limits<float>::quiet_NaN(), 0};
  const Image results = canvas.calculate(operands);
  found.keeps_denormals = results.values[0] == 0x1p-140f;
  found.makes_nan =
      std::isnan(results.values[4]) && std::isnan(results.values[5]) && std::isnan(results.values[6]);
}

// One triangle over half of the target whose planes are exact: only their evaluation rounds.
void probe_interpolation(Canvas& canvas, GlFindings& found) {
  Random random;
  std::array<float, 4> per_x{}, per_y{};
  std::vector<ProbeVertex> corners = {{0, kSide}, {0, 0}, {kSide, 0}};
  for (std::size_t c = 0; c < 4; ++c) {
    per_x[c] = 1.0f + static_cast<float>(random.bits() >> 12) * 0x1p-20f;
    per_y[c] = 1.0f + static_cast<float>(random.bits() >> 12) * 0x1p-20f;
    corners[0].value[c] = kSide * per_y[c];
    corners[1].value[c] = 0.0f;
    corners[2].value[c] = kSide * per_x[c];
  }
  const Image image = canvas.draw(Topology::Triangles, corners);
  bool fused = true, unfused = true;
  for (int y = 0; y < kSide - 1; ++y)
    for (int x = 0; x + y < kSide - 1; ++x)
      for (std::size_t c = 0; c < 4; ++c) {
        const float value = image.at(x, y, static_cast<int>(c)), at_origin = 0.5f * (per_x[c] + per_y[c]);
        const auto column = static_cast<float>(x), row = static_cast<float>(y);
        const float along_x = at_origin + per_x[c] * column, along_y = per_y[c] * row;
        fused = fused && value == std::fma(per_y[c], row, std::fma(per_x[c], column, at_origin));
        unfused = unfused && value == along_x + along_y;
      }
  found.interpolated = fused     ? Interpolated::Fused
                       : unfused ? Interpolated::Unfused
                                 : Interpolated::Otherwise;
}

// Triangles whose left edge is ever further to the right of a pixel's centre: those that still cover it were
// snapped back, from at most half a step.
void probe_corners(Canvas& canvas, GlFindings& found) {
  constexpr int kEvery = 4, kSteps = (kSide / kEvery) * (kSide / kEvery);
  constexpr float kStep = 0.125f / kSteps;
  std::vector<ProbeVertex> corners;
  const auto centre = [](int i) {
    const int column = i % (kSide / kEvery), row = i / (kSide / kEvery);
    return std::pair(static_cast<float>(column * kEvery) + 1.5f, static_cast<float>(row * kEvery) + 1.5f);
  };
  for (int i = 0; i < kSteps; ++i) {
    const auto [x, y] = centre(i);
    const float edge = x + static_cast<float>(i) * kStep;
    corners.push_back({edge, y + 1.5f});
    corners.push_back({edge, y - 1.5f});
    corners.push_back({edge + 2.0f, y});
  }
  const Image image = canvas.draw(Topology::Triangles, corners);
  float snapped_back = kStep;
  for (int i = 0; i < kSteps; ++i) {
    const auto [x, y] = centre(i);
    if (image.at(static_cast<int>(x), static_cast<int>(y), 0) != 0.0f)
      snapped_back = std::max(snapped_back, static_cast<float>(i) * kStep);
  }
  found.drawn_subpixel_bits = static_cast<int>(std::lround(-std::log2(2.0f * snapped_back)));
}

// The number of random points that cover other pixels than the contract says, drawn alone, each in a cell of
// the target.
void probe_points(Canvas& canvas, GlFindings& found) {
  constexpr int kCell = 8, kCells = kSide / kCell, kDraws = GlFindings::kPoints / (kCells * kCells);
  Random random;
  for (int draw = 0; draw < kDraws; ++draw) {
    std::vector<ProbeVertex> points;
    Image expected(Format::R32F, kSide, kSide);
    for (int i = 0; i < kCells * kCells; ++i) {
      const int left = i % kCells * kCell, bottom = i / kCells * kCell;
      ProbeVertex point{static_cast<float>(left) + 3.0f + random.below(2),
                        static_cast<float>(bottom) + 3.0f + random.below(2)};
      point.size = 0.25f * (2.0f + std::floor(random.below(15)));
      // Half of them between two steps of the grid, where rounding has to decide.
      if (draw % 2 == 0) {
        point.x = std::floor(point.x * 256.0f) / 256.0f + 1.0f / 512.0f;
        point.y = std::floor(point.y * 256.0f) / 256.0f + 1.0f / 512.0f;
      }
      points.push_back(point);
      const PixelRange x = pixels_of_point(point.x, point.size), y = pixels_of_point(point.y, point.size);
      for (int row = y.first; row <= y.last; ++row)
        for (int column = x.first; column <= x.last; ++column) expected.at(column, row, 0) = 1.0f;
    }
    const Image image = canvas.draw(Topology::Points, points);
    for (int i = 0; i < kCells * kCells; ++i) {
      bool same = true;
      for (int k = 0; k < kCell * kCell; ++k) {
        const int x = i % kCells * kCell + k % kCell, y = i / kCells * kCell + k / kCell;
        same = same && image.at(x, y, 0) == expected.at(x, y, 0);
      }
      found.misplaced_points += !same;
    }
  }
}

void probe_points_off_target(Canvas& canvas, GlFindings& found) {
  const float middle = 0.5f * kSide;
  const Image image = canvas.draw(Topology::Points, {{.x = -2, .y = middle, .size = 8},
                                                     {.x = kSide + 2, .y = middle, .size = 8},
                                                     {.x = middle, .y = -2, .size = 8},
                                                     {.x = middle, .y = kSide + 2, .size = 8}});
  found.draws_points_off_target =
      std::any_of(image.values.begin(), image.values.end(), [](float v) { return v != 0.0f; });
}

std::string number(float value) {
  char text[32];
  std::snprintf(text, sizeof text, "%g", static_cast<double>(value));
  return text;
}

std::string rounding(int wrong) {
  return wrong == 0 ? "rounded to the nearest float"
                    : std::to_string(wrong) + " of " + std::to_string(GlFindings::kOperands) +
                          " are not the nearest float";
}

}  // namespace

GlFindings probe(GlDevice& device) { return probe(device, device.renderer(), device.limits()); }

GlFindings probe(Device& device, const std::string& renderer, const GlLimits& limits) {
  GlFindings found;
  found.renderer = renderer;
  found.subpixel_bits = limits.subpixel_bits;
  found.smallest_point = limits.smallest_point;
  found.largest_point = limits.largest_point;
  Canvas canvas(device);
  probe_arithmetic(canvas, found);
  probe_special_values(canvas, found);
  probe_interpolation(canvas, found);
  probe_corners(canvas, found);
  probe_points(canvas, found);
  probe_points_off_target(canvas, found);
  return found;
}

DriverClass class_of(const GlFindings& found) {
  // What is drawn decides: zink says 4 of lavapipe's 8. Corners that are cut off instead of rounded show one
  // less.
  if (found.drawn_subpixel_bits < 7) return DriverClass::FourSubpixelBits;
  if (found.contracted_sums > 0) return DriverClass::ContractingHardware;
  const bool exact = found.wrong_quotients + found.wrong_roots + found.wrong_sums == 0;
  const bool llvmpipe = found.renderer.find("llvmpipe") != std::string::npos;
  if (!exact || !llvmpipe || found.interpolated == Interpolated::Otherwise) return DriverClass::Hardware;
  if (found.interpolated == Interpolated::Unfused) return DriverClass::LlvmpipeUnfused;
  return found.misplaced_points == 0 && !found.draws_points_off_target ? DriverClass::LlvmpipeFused
                                                                       : DriverClass::LlvmpipeOtherPoints;
}

std::vector<std::pair<std::string, std::string>> rows_of(const GlFindings& found) {
  static constexpr const char* interpolated[] = {"fused, as the software device does",
                                                 "as the software device does, but unfused", "otherwise"};
  return {
      {"division", rounding(found.wrong_quotients)},
      {"square root", rounding(found.wrong_roots)},
      {"precise a * b + c", found.contracted_sums == 0
                                ? "not contracted, " + rounding(found.wrong_sums)
                                : std::to_string(found.contracted_sums) + " of " +
                                      std::to_string(GlFindings::kOperands) + " are contracted"},
      {"fma(a, b, c)", found.fuses_fma ? "rounds once" : "rounds twice"},
      {"denormals", found.keeps_denormals ? "kept" : "flushed"},
      {"NaN", found.makes_nan ? "as IEEE 754 has it" : "lost"},
      {"interpolation", interpolated[static_cast<std::size_t>(found.interpolated)]},
      {"sub-pixel bits", std::to_string(found.subpixel_bits) + " said, " +
                             std::to_string(found.drawn_subpixel_bits) + " drawn"},
      {"point sizes", number(found.smallest_point) + " to " + number(found.largest_point) +
                          (found.largest_point < kLargestPointSize ? ": drawn as quadrilaterals" : "")},
      {"points", std::to_string(found.misplaced_points) + " of " + std::to_string(GlFindings::kPoints) +
                     " cover other pixels"},
      {"points off the target", found.draws_points_off_target ? "drawn" : "left out"},
  };
}

}  // namespace caustics
