#include "lab/paper/shots.hpp"

#include <algorithm>
#include <cmath>

namespace caustics::paper {

double Shots::relative_l1(const std::string& a, const std::string& b, const std::string& wanted) const {
  const FloorLayer first = layer(a, wanted), second = layer(b, wanted);
  double difference = 0.0, sum = 0.0;
  for (std::size_t i = 0; i < second.pixels.size(); ++i)
    for (std::size_t c = 0; c < 3; ++c) {
      difference += std::fabs(first.pixels[i][c] - second.pixels[i][c]);
      sum += second.pixels[i][c];
    }
  return sum > 0.0 ? difference / sum : 0.0;
}

double Shots::flux(const std::string& name, const std::string& account, int channel, int light) const {
  return stats(name)
      .at("lights")
      .at(static_cast<std::size_t>(light))
      .at("flux")
      .at(account)
      .at(static_cast<std::size_t>(channel));
}

double Shots::share(const std::string& name, const std::string& account, int light) const {
  double part = 0.0, whole = 0.0;
  for (int c = 0; c < 3; ++c) {
    part += flux(name, account, c, light);
    whole += flux(name, "entered", c, light);
  }
  return whole > 0.0 ? part / whole : 0.0;
}

double Shots::residual(const std::string& name) const {
  double worst = 0.0;
  for (const auto& light : stats(name).at("lights"))
    worst = std::max<double>(worst, light.at("flux").at("residual"));
  return worst;
}

double Shots::milliseconds(const std::string& name, const std::vector<std::string>& passes,
                           const char* clock) const {
  double sum = 0.0;
  for (const auto& pass : stats(name).at("passes")) {
    const std::string label = pass.at("pass");
    if (std::find(passes.begin(), passes.end(), label.substr(0, label.find('['))) != passes.end())
      sum += pass.at(clock).get<double>();
  }
  return sum;
}

double Shots::samples_passed(const std::string& name, const std::string& wanted) const {
  double sum = 0.0;
  for (const auto& pass : stats(name).at("passes")) {
    const std::string label = pass.at("pass");
    if (label.starts_with(wanted + "[")) sum += pass.at("samples_passed").get<double>();
  }
  return sum;
}

}  // namespace caustics::paper
