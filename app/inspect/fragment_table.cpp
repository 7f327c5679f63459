#include "app/inspect/fragment_table.hpp"

namespace caustics::app {

namespace {

// The place of each fragment once they are sorted by texel, and where each texel's begin.
std::vector<std::uint32_t> places(const std::vector<std::uint32_t>& texel, std::size_t texels,
                                  std::vector<std::uint32_t>& start) {
  start.assign(texels + 1, 0);
  for (const std::uint32_t t : texel) ++start[t + 1];
  for (std::size_t t = 1; t < start.size(); ++t) start[t] += start[t - 1];
  std::vector<std::uint32_t> next(start.begin(), start.end() - 1), place;
  place.reserve(texel.size());
  for (const std::uint32_t t : texel) place.push_back(next[t]++);
  return place;
}

template <class T>
void move_to(const std::vector<std::uint32_t>& place, std::vector<T>& values) {
  std::vector<T> moved(values.size());
  const std::size_t each = place.empty() ? 0 : values.size() / place.size();  // 0: not taken
  for (std::size_t i = 0; i < place.size(); ++i)
    for (std::size_t k = 0; k < each; ++k) moved[place[i] * each + k] = values[i * each + k];
  values = std::move(moved);
}

}  // namespace

FragmentTable fragment_table(const RenderedFrame& frame, const PlannedPass& pass, const TargetsBefore& before,
                             const std::vector<bool>& wanted) {
  FragmentTable table;
  std::vector<std::uint32_t> texel;
  table.values.resize(pass.writes.size());
  const auto take = [&](const FragmentOnTexel& f) {
    texel.push_back(static_cast<std::uint32_t>(f.y * pass.width + f.x));
    table.primitive.push_back(f.primitive);
    table.draw.push_back(static_cast<std::uint16_t>(f.draw));
    table.outcome.push_back(static_cast<std::uint8_t>(f.outcome));
    if (pass.depth >= 0) table.depth.push_back(f.depth);
    for (std::size_t i = 0; i < table.values.size(); ++i) {
      const int channels = channel_count(pass.definition->writes[i].format);
      if (wanted[i])
        table.values[i].insert(table.values[i].end(), f.given[i].begin(), f.given[i].begin() + channels);
    }
  };
  replay_fragments(frame.device(), frame.prepare(pass), before, {0, 0, pass.width, pass.height}, take);
  const std::vector<std::uint32_t> place = places(
      texel, static_cast<std::size_t>(pass.width) * static_cast<std::size_t>(pass.height), table.start);
  move_to(place, table.primitive);
  move_to(place, table.draw);
  move_to(place, table.outcome);
  move_to(place, table.depth);
  for (std::vector<float>& values : table.values) move_to(place, values);
  return table;
}

}  // namespace caustics::app
