// What `caustics bench` measures: frames of one scene on one device, or on two by turns.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "app/frame_options.hpp"
#include "pipeline/gpu/pass_run.hpp"

namespace caustics::app {

struct BenchRequest {
  FrameRequest frame;
  bool against_gl = false;
  int frames = 10;  // measured, on each device
};

// Milliseconds on the wall and on all processors, by measured frame.
struct Costs {
  std::vector<double> wall, processor;
  void add(double wall_milliseconds, double processor_milliseconds) {
    wall.push_back(wall_milliseconds);
    processor.push_back(processor_milliseconds);
  }
};

struct BenchedDevice {
  Backend backend = Backend::Software;
  std::string description;
  double prepared = 0.0;           // milliseconds: loading, planning, making textures
  std::vector<Costs> passes;       // by BenchRun::passes
  std::vector<PassResult> counts;  // likewise, of the last frame
  Costs sums;                      // of all passes
  Costs frames;                    // from the first pass's preparation until the device has finished
};

struct BenchedPass {
  std::string label, name;  // "landing[sun].far" of "landing"
  bool counts_samples = false;
  std::uint64_t bytes = 0;       // of its attachments and of the textures bound for reading, each once
  std::uint64_t operations = 0;  // of its shaders on floats, as one lane does them (kernel.hpp)
};

struct BenchRun {
  std::string scene;
  Settings settings;  // with the sides that were chosen
  int threads = 1;
  std::vector<BenchedPass> passes;
  std::vector<BenchedDevice> devices;  // the software device first
  double bandwidth;                    // bytes a second
  double peak;                         // operations a second (machine_limits.hpp)
  std::uint64_t peak_memory;           // bytes of this process, of all devices together
  // All attachments of the frame before the measured ones, and of the one after them.
  std::size_t attachments;
  std::string digest;         // of all their hashes, on the first device
  std::size_t differing = 0;  // attachments of which both devices' hashes differ
  std::string allowance;      // the driver's class where it may differ
  std::string fault;          // one line: which pass gave other bits than it should
};

// Uses so many threads, on llvmpipe too: its number is fixed when its first device of a process is made.
BenchRun measure_frames(const BenchRequest& request, int threads);

}  // namespace caustics::app
