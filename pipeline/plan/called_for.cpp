#include "pipeline/plan/called_for.hpp"

#include <algorithm>

namespace caustics {

namespace {

std::string named_reason(Effect Effects::*effect, const Effects& effects) {
  for (const NamedEffect& named : named_effects())
    if (named.effect == effect) return std::string(named.name) + ": " + (effects.*effect).reason;
  return (effects.*effect).reason;
}

// "cells: landings are splatted one by one", or nothing where the effect is active.
std::optional<std::string> missing(Effect Effects::*wanted, const Effects& effects) {
  if (!wanted || (effects.*wanted).active) return {};
  return named_reason(wanted, effects);
}

}  // namespace

std::optional<std::string> not_called_for(const Pass& pass, const DrawnFor& drawn_for,
                                          const Effects& effects) {
  for (Effect Effects::*wanted : pass.when)
    if (auto reason = missing(wanted, effects)) return reason;
  if (!pass.unless.empty() && std::all_of(pass.unless.begin(), pass.unless.end(),
                                          [&](Effect Effects::*other) { return (effects.*other).active; }))
    return named_reason(pass.unless.back(), effects);
  return missing(drawn_for.also, effects);
}

}  // namespace caustics
