#include "app/reference_layers.hpp"

#include <algorithm>
#include <map>

#include "app/output/image_file.hpp"
#include "app/shell/terminal.hpp"
#include "lab/reference/tracer/direct.hpp"
#include "pipeline/gpu/error.hpp"
#include "pipeline/settings/nearest.hpp"

namespace caustics::app {

namespace {

struct ReferenceLayer {
  const char* name;
  const char* meaning;
  int count = 3;
};

constexpr ReferenceLayer kReferenceLayers[] = {
    {"caustic", "illuminance by caustics, lux; 0 on casters"},
    {"caustic_error", "its standard error, lux"},
    {"direct", "illuminance by the lights after shadows, lux; 0 on casters"},
    {"position", "glTF world coordinates, metres"},
    {"normal", "unit, world axes"},
    {"depth", "metres along the view axis", 1},
    {"coverage", "1 where there is a surface, else 0", 1},
};

const ReferenceLayer& find_reference_layer(const std::string& name) {
  const auto found = std::find_if(std::begin(kReferenceLayers), std::end(kReferenceLayers),
                                  [&](const ReferenceLayer& layer) { return layer.name == name; });
  if (found != std::end(kReferenceLayers)) return *found;
  if (name == "beauty")
    throw Error(
        ExitCode::WrongUsage,
        "the reference has no layer 'beauty': it traces light onto surfaces, not what the camera sees in "
        "glass; 'caustic' and 'direct' are what to compare");
  std::vector<std::string> names;
  for (const ReferenceLayer& layer : kReferenceLayers) names.emplace_back(layer.name);
  throw Error(ExitCode::WrongUsage, "--aov has no layer " + in_quotes(name) + suggestion(name, names));
}

Image image_of(const std::vector<float>& values, int width, int height) {
  Image image(Format::RGBA32F, width, height);
  for (std::size_t i = 0; i < values.size() / 3; ++i)
    for (std::size_t c = 0; c < 3; ++c) image.values[4 * i + c] = values[3 * i + c];
  return image;
}

// Four values of each pixel's surface, three and one.
template <class Three, class One>
Image surface_image(const tracer::Film& film, Three three, One one) {
  Image image(Format::RGBA32F, film.width(), film.height());
  for (std::size_t i = 0; i < film.pixels(); ++i) {
    const tracer::Seen& seen = film.seen(i);
    if (seen.mesh < 0) continue;
    const glm::dvec3 v = three(seen);
    for (int c = 0; c < 3; ++c) image.values[4 * i + static_cast<std::size_t>(c)] = static_cast<float>(v[c]);
    image.values[4 * i + 3] = static_cast<float>(one(seen));
  }
  return image;
}

// The layer's image, and its first channel in it.
Image image_for(const std::string& name, const tracer::Tracer& t, int threads) {
  const tracer::Film& film = t.film();
  const auto colors = [&](const std::vector<float>& v) { return image_of(v, film.width(), film.height()); };
  if (name == "caustic") return colors(t.caustic());
  if (name == "caustic_error") return colors(t.caustic_error());
  if (name == "direct") return colors(direct_light(t.world(), film, threads));
  if (name == "position" || name == "coverage")
    return surface_image(
        film, [](const tracer::Seen& s) { return s.position; }, [](const tracer::Seen&) { return 1.0; });
  return surface_image(
      film, [](const tracer::Seen& s) { return s.normal; }, [](const tracer::Seen& s) { return s.depth; });
}

}  // namespace

std::vector<std::string> parse_reference_layers(const std::string& list) {
  std::vector<std::string> layers;
  for (std::size_t start = 0; start <= list.size();) {
    const std::size_t end = std::min(list.find(',', start), list.size());
    const std::string name = find_reference_layer(list.substr(start, end - start)).name;
    if (std::find(layers.begin(), layers.end(), name) == layers.end()) layers.push_back(name);
    start = end + 1;
  }
  return layers;
}

std::vector<std::string> all_reference_layers() {
  std::vector<std::string> names;
  for (const ReferenceLayer& layer : kReferenceLayers) names.emplace_back(layer.name);
  return names;
}

void list_reference_layers(Parser& parser) {
  for (const ReferenceLayer& layer : kReferenceLayers)
    parser.list("Layers for --aov, of the first surface that is hit", layer.name, {layer.meaning});
}

void write_reference_layers(const std::filesystem::path& path, const std::vector<std::string>& layers,
                            const tracer::Tracer& tracer, int threads) {
  std::map<std::string, Image> images;
  std::vector<ExrChannel> channels;
  for (const std::string& name : layers) {
    const ReferenceLayer& layer = find_reference_layer(name);
    const Image& image = images[name] = image_for(name, tracer, threads);
    if (count_non_finite(image) > 0)
      throw Error(ExitCode::NumericFault,
                  "the layer '" + name + "' has values that are not finite; no picture is written");
    const bool in_world = name == "position";
    for (int c = 0; c < layer.count; ++c)
      channels.push_back({name + "." + "RGBA"[c], &image, layer.count == 1 ? 3 : c,
                          in_world ? tracer.world().scene().origin[c] : 0.0, in_world ? 3 : -1});
  }
  write_exr(path, channels);
}

}  // namespace caustics::app
