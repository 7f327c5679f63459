#include "pipeline/gpu/fault.hpp"

#include <cstdint>
#include <cstdlib>

int caustics_fault = 0;

namespace {

// FNV-1a without the sign bit, as in faults.py. Before anything else is initialised.
[[gnu::constructor(101)]] void choose_fault() {
  const char* name = std::getenv("CAUSTICS_FAULT");
  if (name == nullptr || *name == '\0') return;
  std::uint32_t hash = 2166136261u;
  for (; *name != '\0'; ++name) hash = (hash ^ static_cast<unsigned char>(*name)) * 16777619u;
  caustics_fault = static_cast<int>(hash & 0x7fffffffu);
}

}  // namespace
