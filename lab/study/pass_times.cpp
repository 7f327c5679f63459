#include "lab/study/pass_times.hpp"

#include <algorithm>

namespace caustics::study {

namespace {

// "caustic_map[sun]" -> "caustic_map"
// "landing.far" of "landing[sun].far".
std::string pass_name(const std::string& label) {
  const std::size_t owner = label.find('['), end = label.rfind(']');
  return owner == label.npos ? label : label.substr(0, owner) + label.substr(end + 1);
}

}  // namespace

void Clock::add(const std::vector<PassReport>& reports) {
  double all = 0.0, caustic = 0.0;
  for (const PassReport& report : reports) {
    if (!picture_labels_.count(report.label)) continue;
    const double milliseconds = report.result.milliseconds;
    const bool makes = caustic_labels_.count(report.label) > 0;
    all += milliseconds;
    if (makes) caustic += milliseconds;
    book(pass_name(report.label), makes, milliseconds);
  }
  frame_.push_back(all);
  caustic_.push_back(caustic);
}

FrameTimes Clock::times() const {
  FrameTimes result{times_of(frame_), times_of(caustic_), {}};
  for (const Entry& entry : entries_) {
    result.passes.push_back(entry.pass);
    result.passes.back().runs /= static_cast<int>(frame_.size());
    result.passes.back().median = times_of(entry.frames).median;
  }
  return result;
}

void Clock::book(const std::string& name, bool caustic, double milliseconds) {
  auto found = std::find_if(entries_.begin(), entries_.end(),
                            [&](const Entry& entry) { return entry.pass.name == name; });
  if (found == entries_.end())
    found = entries_.insert(entries_.end(), {{.name = name, .caustic = caustic}, {}});
  ++found->pass.runs;
  found->frames.resize(frame_.size() + 1);
  found->frames.back() += milliseconds;
}

}  // namespace caustics::study
