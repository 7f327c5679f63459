#include "app/compare/measurement.hpp"

#include <algorithm>

#include "app/output/display_pair.hpp"
#include "app/output/image_layers.hpp"
#include "app/shell/interrupt.hpp"

namespace caustics::app {

namespace {

PlanePair pair_of(const ChannelDifference& channel) { return {channel.a->view, channel.b->view}; }

std::vector<PlanePair> pairs_of(const std::vector<const ChannelDifference*>& channels) {
  std::vector<PlanePair> pairs;
  pairs.reserve(channels.size());
  for (const ChannelDifference* channel : channels) pairs.push_back(pair_of(*channel));
  return pairs;
}

bool one_size(const std::vector<const ChannelDifference*>& channels) {
  return std::all_of(channels.begin(), channels.end(), [&](const ChannelDifference* each) {
    return each->a->view.width == channels[0]->a->view.width &&
           each->a->view.height == channels[0]->a->view.height;
  });
}

LayerMeasure& layer_named(std::vector<LayerMeasure>& layers, const std::string& name) {
  for (LayerMeasure& each : layers) {
    if (each.layer == name) return each;
  }
  layers.emplace_back().layer = name;
  return layers.back();
}

// Layers and their channels that can be compared; colours alone where there are any.
std::vector<LayerMeasure> layers_of(const PlanesDifference& difference) {
  std::vector<LayerMeasure> layers;
  for (const ChannelDifference& channel : difference.channels) {
    if (!channel.mismatch.empty()) continue;
    layer_named(layers, layer_of(channel.name)).channels.push_back(&channel);
  }
  for (LayerMeasure& each : layers) {
    const auto colored = [](const ChannelDifference* channel) { return is_color(channel->name); };
    if (!std::any_of(each.channels.begin(), each.channels.end(), colored)) continue;
    std::erase_if(each.channels, [&](const auto* channel) { return !colored(channel); });
  }
  std::erase_if(layers, [](const LayerMeasure& each) { return !one_size(each.channels); });
  return layers;
}

void add_flip(LayerMeasure& layer, const Selection& selection) {
  if (layer.metrics.non_finite > 0) {
    layer.no_flip = "has values that are not finite";
    return;
  }
  DisplayPair pair = display_pair(layer.channels, selection);
  if (!pair.impossible.empty()) {
    layer.no_flip = pair.impossible;
    return;
  }
  LayerFlip flip{.figures = {}, .exposure = pair.exposure, .map = flip_map(pair.a, pair.b)};
  flip.figures = flip_figures(flip.map, selection.from_bottom());
  layer.flip = std::move(flip);
}

}  // namespace

Measurement measure(const PlanesDifference& difference, Selection selection, bool with_flip) {
  Measurement result;
  result.selection = std::move(selection);
  result.has_flip = with_flip;
  for (const ChannelDifference& channel : difference.channels) {
    const PlanePair pair = channel.mismatch.empty() ? pair_of(channel) : PlanePair{};
    result.channels.push_back(image_metrics({&pair, 1}, result.selection.mask));
    stop_if_interrupted();
  }
  result.layers = layers_of(difference);
  for (LayerMeasure& layer : result.layers) {
    layer.metrics = image_metrics(pairs_of(layer.channels), result.selection.mask);
    stop_if_interrupted();
    if (with_flip) add_flip(layer, result.selection);
    stop_if_interrupted();
  }
  return result;
}

std::vector<NamedMetric> named_metrics(const LayerMeasure& layer) {
  std::vector<NamedMetric> list = named_metrics(layer.metrics);
  const auto of_flip = [&](double FlipFigures::*figure) {
    return layer.flip ? std::optional<double>(layer.flip->figures.*figure) : std::nullopt;
  };
  list.push_back({"flip_mean", of_flip(&FlipFigures::mean)});
  list.push_back({"flip_median", of_flip(&FlipFigures::median)});
  list.push_back({"flip_max", of_flip(&FlipFigures::largest)});
  return list;
}

}  // namespace caustics::app
