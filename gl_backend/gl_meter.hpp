// What a run cost: its time and the driver's counts.
#pragma once
#include "gl_backend/gl_object.hpp"
#include "pipeline/gpu/pass_run.hpp"
#include "pipeline/gpu/stopwatch.hpp"

namespace caustics::gl {

// Time comes from GL_TIME_ELAPSED on a GPU. Software renderers answer that query before they have
// drawn, so there the clock runs until glFinish returns, and processor time is that of their threads too.
class RunMeter {
 public:
  // One that does not measure does nothing.
  RunMeter(bool measures, bool software_renderer);
  void begin();
  // Fills in what was counted since begin(), and leaves what the driver does not count as it is. Waits for
  // the driver only for figures that were asked for.
  void end(PassResult& result);
  // Ends the queries of begin(), as end() does; of a run that failed. Sets error flags where none is open.
  void end_queries();
  bool measures() const { return measures_; }

 private:
  bool measures_, wall_clock_, counts_pipeline_ = false;
  QueryObject time_, vertices_, primitives_, fragments_;
  Stopwatch watch_;
};

}  // namespace caustics::gl
