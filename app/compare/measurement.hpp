// The figures of `caustics compare`: how far A is from the truth B, layer by layer.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "app/compare/image_difference.hpp"
#include "app/selection.hpp"
#include "lab/metrics/flip.hpp"
#include "lab/metrics/image_metrics.hpp"

namespace caustics::app {

// FLIP of a layer as a screen shows it.
struct LayerFlip {
  FlipFigures figures;
  std::optional<double> exposure;  // none: stored as display values
  Image map;                       // rows from the bottom
};

// A layer's colour channels R, G and B together; where it has none, all of its channels. Of these
// only those that both images have in one size.
struct LayerMeasure {
  std::string layer;                               // "" without a name
  std::vector<const ChannelDifference*> channels;  // measured, in the order of the difference
  ImageMetrics metrics;
  std::optional<LayerFlip> flip;
  std::string no_flip;  // why `flip` was asked for and is none
};

struct Measurement {
  Selection selection;
  bool has_flip = false;               // was asked for
  std::vector<ImageMetrics> channels;  // one for each of the difference's channels; all none
                                       // without a counterpart
  std::vector<LayerMeasure> layers;    // in the order of their first channels
};

// `difference` lives as long as the result.
Measurement measure(const PlanesDifference& difference, Selection selection, bool with_flip);

// Every figure of a layer by name, those of named_metrics(), "flip_mean", "flip_median" and "flip_max": these
// without a value where FLIP was not asked for.
std::vector<NamedMetric> named_metrics(const LayerMeasure& layer);

}  // namespace caustics::app
