// Occlusion queries, and the drawing that depends on them: conditional rendering (OpenGL 4.5, section 10.9).
#pragma once
#include <map>
#include <optional>

#include "gl_backend/gl_object.hpp"
#include "pipeline/gpu/pass_run.hpp"

namespace caustics::gl {

class OcclusionQueries {
 public:
  // Counts the samples that pass from here to end().
  void begin(OcclusionQuery query);
  void end();
  // What was counted; waits for the driver. Nothing of a query that nothing was counted into.
  std::optional<std::uint64_t> samples(OcclusionQuery query) const;
  // Draws from here to end_condition() are left out where the query holds 0 samples. A query that nothing was
  // counted into leaves nothing out.
  void begin_condition(OcclusionQuery query);
  void end_condition();
  // Ends what may be open, and forgets what was counted, of a run that failed. Sets error flags where nothing
  // is open.
  void drop();

 private:
  std::map<OcclusionQuery, QueryObject> queries_;
  bool counting_ = false, conditional_ = false;
};

}  // namespace caustics::gl
