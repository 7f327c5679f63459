// How long the passes of a setting took, over several frames.
#pragma once
#include <set>
#include <string>
#include <vector>

#include "lab/study/row.hpp"
#include "pipeline/renderer/run_plan.hpp"

namespace caustics::study {

struct FrameTimes {
  Times frame;    // all passes of a picture
  Times caustic;  // those that the caustic maps depend on, the maps included
  std::vector<PassTime> passes;
};

// Adds up frames, pass by pass. `picture`, `caustic`: labels of the passes that count as such. The layer's
// own pass, which is there for the error alone, is in neither; nor are the steps of water, whose number
// depends on the moment shown before.
class Clock {
 public:
  Clock(std::set<std::string> picture, std::set<std::string> caustic)
      : picture_labels_(std::move(picture)), caustic_labels_(std::move(caustic)) {}

  void add(const std::vector<PassReport>& reports);
  // Of the frames so far, one at least.
  FrameTimes times() const;

 private:
  struct Entry {
    PassTime pass;
    std::vector<double> frames;
  };

  void book(const std::string& name, bool caustic, double milliseconds);

  std::set<std::string> picture_labels_, caustic_labels_;
  std::vector<double> frame_, caustic_;  // by frames
  std::vector<Entry> entries_;
};

}  // namespace caustics::study
