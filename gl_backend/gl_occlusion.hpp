// Occlusion queries, and the drawing that depends on them: conditional rendering (OpenGL 4.5, section 10.9).
#pragma once
#include <map>

#include "gl_backend/gl_object.hpp"
#include "pipeline/gpu/device.hpp"

namespace caustics::gl {

class OcclusionQueries {
 public:
  // Counts the samples that pass from here to end().
  void begin(OcclusionQuery query);
  void end();
  // What was counted; waits for the driver. Of a query that nothing was counted into: none.
  std::uint64_t samples(OcclusionQuery query) const;
  // Draws from here to end_condition() are left out where the query holds 0 samples. None, and a query that
  // nothing was counted into, leave nothing out.
  void begin_condition(OcclusionQuery query);
  void end_condition();
  // Ends what is open, of a run that failed.
  void drop();

 private:
  std::map<OcclusionQuery, QueryObject> queries_;
  bool counting_ = false, conditional_ = false;
};

}  // namespace caustics::gl
