#include "app/probe/texel_report.hpp"

#include <algorithm>
#include <cstdio>

#include "app/flux.hpp"
#include "app/json.hpp"
#include "app/output/light_groups.hpp"
#include "app/shell/terminal.hpp"
#include "app/texture_label.hpp"
#include "pipeline/measure/ledger.hpp"

namespace caustics::app {

namespace {

// As many as a person reads; --json has them all.
constexpr std::size_t kMostLines = 12;

void print_values(const std::string& label, const float* values, int count) {
  std::string line = "  " + label;
  line.resize(std::max<std::size_t>(line.size() + 1, 26), ' ');
  for (int i = 0; i < count; ++i) {
    std::string value = significant(static_cast<double>(values[i]), 9);
    value.insert(0, value.size() < 16 ? 16 - value.size() : 1, ' ');
    line += value;
  }
  std::printf("%s\n", line.c_str());
}

void print_values(const std::vector<NamedValues>& list) {
  for (const NamedValues& v : list) print_values(v.name, v.values.data(), v.count);
}

std::string status_of(const ProbedTexel& texel) {
  if (texel.stored.empty() || texel.stored.front().name != kLanding) return {};
  return std::string(name_of(static_cast<LandingStatus>(static_cast<int>(texel.stored.front().values[3]))));
}

Json json_of(const float* values, int count) { return std::vector<float>(values, values + count); }

Json json_of(const std::vector<NamedValues>& list) {
  Json json = Json::array();
  for (const NamedValues& v : list)
    json.push_back({{"name", v.name}, {"values", json_of(v.values.data(), v.count)}});
  return json;
}

// "0.25 0.5": a texel's channels.
std::string text_of(const TexelValue& value, int channels) {
  std::string text;
  for (int c = 0; c < channels; ++c)
    text += (c ? " " : "") + significant(static_cast<double>(value[static_cast<std::size_t>(c)]), 9);
  return text;
}

std::string plural(std::size_t count, const std::string& name) {
  return grouped(count) + " " + name + (count == 1 ? "" : "s");
}

}  // namespace

bool agrees(const ProbedVertex& vertex) {
  return std::all_of(vertex.passes.begin(), vertex.passes.end(),
                     [](const auto& pass) { return pass.second.agrees; });
}

void print(const RenderedFrame& frame, const ProbedVertex& vertex) {
  const int grid = frame.grid_of(samples_of(frame.scene(), vertex.source).front());
  std::printf("grid vertex %d,%d of light %s, grid %dx%d; metres, scene space\n", vertex.x, vertex.y,
              light_label(frame.scene(), vertex.source).c_str(), grid, grid);
  for (const auto& [label, texel] : vertex.passes) {
    if (frame.effects().further_surfaces.active) std::printf("\n%s\n", label.c_str());
    std::printf("\nthis texel of what the pass reads\n");
    print_values(texel.inputs);
    std::printf("\nwhat it computes, in order\n");
    print_values(texel.trace);
    std::printf("\nwhat it stores\n");
    print_values(texel.stored);
    if (const std::string status = status_of(texel); !status.empty())
      std::printf("\nstatus: %s\n", status.c_str());
  }
  if (vertex.passes.empty()) std::printf("\nno caster is there\n");
  std::printf("the probe and the rendered %s %s\n", vertex.passes.size() == 1 ? "texel" : "texels",
              agrees(vertex) ? "agree to the bit" : "DIFFER");
}

Json json_of(const ProbedVertex& vertex) {
  Json json = {{"vertex", {vertex.x, vertex.y}}, {"light", vertex.source}, {"passes", Json::array()}};
  for (const auto& [label, texel] : vertex.passes) {
    Json pass = {{"pass", label},
                 {"reads", json_of(texel.inputs)},
                 {"computes", json_of(texel.trace)},
                 {"stores", json_of(texel.stored)}};
    if (const std::string status = status_of(texel); !status.empty()) pass["status"] = status;
    json["passes"].push_back(std::move(pass));
  }
  json["agrees"] = agrees(vertex);
  return json;
}

namespace {

// "triangle 12 of 'ball'", "cell 57,24".
std::string name_of_primitive(const TexelHistory& history, const FragmentOnTexel& f) {
  const std::string& mesh = history.meshes[f.draw];
  if (history.columns > 0)
    return history.kind + " " + std::to_string(f.primitive % history.columns) + "," +
           std::to_string(f.primitive / history.columns);
  return history.kind + " " + std::to_string(f.primitive) +
         (mesh.empty() ? "" : " of '" + one_line(mesh) + "'");
}

}  // namespace

void print(const TexelHistory& history) {
  std::printf("%s, texel %d,%d of %dx%d, from the left and the bottom\n", history.pass->label.c_str(),
              history.x, history.y, history.pass->width, history.pass->height);
  for (std::size_t i = 0; i < history.attachments.size(); ++i)
    std::printf("  before       %s %s\n", history.attachments[i].c_str(),
                text_of(history.before[i], history.channels[i]).c_str());
  for (const FragmentOnTexel& f : history.fragments) {
    std::printf("\n%s: %s", name_of_primitive(history, f).c_str(), std::string(name_of(f.outcome)).c_str());
    if (history.pass->depth >= 0)
      std::printf(", depth %s where %s was", significant(static_cast<double>(f.depth), 9).c_str(),
                  significant(static_cast<double>(f.depth_before), 9).c_str());
    std::printf("\n");
    for (std::size_t i = 0; i < history.attachments.size(); ++i) {
      if (f.outcome == FragmentOutcome::Discarded) continue;
      std::printf("  gives        %s %s\n", history.attachments[i].c_str(),
                  text_of(f.given[i], history.channels[i]).c_str());
      if (f.outcome == FragmentOutcome::Passed)
        std::printf("  after it     %s %s\n", history.attachments[i].c_str(),
                    text_of(f.after[i], history.channels[i]).c_str());
    }
  }
  const auto passed = std::count_if(history.fragments.begin(), history.fragments.end(),
                                    [](const auto& f) { return f.outcome == FragmentOutcome::Passed; });
  std::printf("\n%s, of which %td passed%s\n", plural(history.fragments.size(), "fragment").c_str(), passed,
              history.left_out
                  ? (": the pass drew nothing: " + std::string(why_left_out(*history.pass))).c_str()
                  : "");
  std::printf("the history and the rendered texel %s\n", history.equal ? "agree to the bit" : "DIFFER");
}

Json json_of(const TexelHistory& history) {
  Json json = {{"pass", history.pass->label},
               {"texel", {history.x, history.y}},
               {"size", {history.pass->width, history.pass->height}},
               {"attachments", history.attachments},
               {"left_out", history.left_out},
               {"fragments", Json::array()}};
  const auto values = [&](const std::vector<TexelValue>& texels) {
    Json list = Json::array();
    for (std::size_t i = 0; i < texels.size(); ++i)
      list.push_back(json_of(texels[i].data(), history.channels[i]));
    return list;
  };
  json["before"] = values(history.before);
  for (const FragmentOnTexel& f : history.fragments)
    json["fragments"].push_back({{"draw", f.draw},
                                 {"mesh", history.meshes[f.draw]},
                                 {"primitive", f.primitive},
                                 {"name", name_of_primitive(history, f)},
                                 {"outcome", name_of(f.outcome)},
                                 {"depth", f.depth},
                                 {"depth_before", f.depth_before},
                                 {"gives", values(f.given)},
                                 {"after", values(f.after)}});
  json["rendered"] = values(history.stored);
  json["agrees"] = history.equal;
  return json;
}

bool agrees(const ProbedPixel& pixel) {
  return std::all_of(pixel.lights.begin(), pixel.lights.end(),
                     [](const LightOnPixel& light) { return light.agrees; });
}

namespace {

void print_light(const RenderedFrame& frame, const LightOnPixel& light) {
  const int source = frame.scene().lights[static_cast<std::size_t>(light.light)].source;
  std::printf("\nlight %s\n", light_label(frame.scene(), source).c_str());
  print_values("direct, lux", light.direct.data(), 3);
  print_values("caustic, lux", light.caustic.data(), 3);
  if (light.texels.empty()) return;
  const PlannedTexture& map = frame.plan().textures[static_cast<std::size_t>(light.texels.front().texture)];
  std::printf("  the caustic comes from %s of %s, around %d,%d, and there from %s of the grid:\n",
              plural(light.texels.size(), "texel").c_str(),
              one_line(texture_label(map, frame.scene())).c_str(), light.texels.front().x,
              light.texels.front().y, plural(light.contributions.size(), "primitive").c_str());
  for (std::size_t i = 0; i < std::min(kMostLines, light.contributions.size()); ++i) {
    const Contribution& c = light.contributions[i];
    std::printf("    %6s  %s %d,%d by %s\n", percent(c.share).c_str(), c.kind.c_str(), c.x, c.y,
                c.pass.c_str());
  }
  if (light.contributions.size() > kMostLines)
    std::printf("            and %s with less (--json has all)\n",
                grouped(light.contributions.size() - kMostLines).c_str());
}

}  // namespace

void print(const RenderedFrame& frame, const ProbedPixel& pixel) {
  std::printf("pixel %d,%d from the left and the top: %s\n", pixel.x, pixel.y, pixel.shows.c_str());
  print_values("beauty, nit", pixel.beauty.data(), 3);
  print_values("as displayed, 0..1", pixel.picture.data(), 3);
  for (const LightOnPixel& light : pixel.lights) print_light(frame, light);
  std::printf("\nthe probe and the rendered pixel %s\n", agrees(pixel) ? "agree to the bit" : "DIFFER");
}

Json json_of(const RenderedFrame& frame, const ProbedPixel& pixel) {
  Json json = {{"pixel", {pixel.x, pixel.y}},
               {"shows", pixel.shows},
               {"beauty", pixel.beauty},
               {"picture", pixel.picture},
               {"lights", Json::array()}};
  for (const LightOnPixel& light : pixel.lights) {
    Json texels = Json::array(), contributions = Json::array();
    for (const MapTexel& t : light.texels)
      texels.push_back({{"map", frame.plan().textures[static_cast<std::size_t>(t.texture)].name},
                        {"texel", {t.x, t.y}},
                        {"weight", t.weight}});
    for (const Contribution& c : light.contributions)
      contributions.push_back({{"pass", c.pass}, {c.kind, {c.x, c.y}}, {"share", c.share}});
    json["lights"].push_back({{"light", light.light},
                              {"direct", light.direct},
                              {"caustic", light.caustic},
                              {"texels", std::move(texels)},
                              {"contributions", std::move(contributions)},
                              {"explained", light.explained},
                              {"accounted", light.accounted}});
  }
  json["agrees"] = agrees(pixel);
  return json;
}

}  // namespace caustics::app
