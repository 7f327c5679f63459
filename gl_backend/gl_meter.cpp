#include "gl_backend/gl_meter.hpp"

namespace caustics::gl {

namespace {

// Not glCreateQueries: Mesa 22 refuses to make queries of pipeline statistics with it.
QueryObject make_query() {
  GLuint id = 0;
  glGenQueries(1, &id);
  return QueryObject(id);
}

std::uint64_t answer(const QueryObject& query) {
  GLuint64 value = 0;
  glGetQueryObjectui64v(query.id(), GL_QUERY_RESULT, &value);
  return value;
}

}  // namespace

RunMeter::RunMeter(bool measures, bool software_renderer)
    : measures_(measures), wall_clock_(software_renderer) {
  if (!measures) return;
  if (!wall_clock_) time_ = make_query();
  counts_pipeline_ = epoxy_gl_version() >= 46 || epoxy_has_gl_extension("GL_ARB_pipeline_statistics_query");
  if (!counts_pipeline_) return;
  vertices_ = make_query();
  primitives_ = make_query();
  fragments_ = make_query();
}

void RunMeter::begin() {
  if (!measures_) return;
  if (wall_clock_) {
    glFinish();
  } else {
    glBeginQuery(GL_TIME_ELAPSED, time_.id());
  }
  watch_ = Stopwatch();
  if (!counts_pipeline_) return;
  glBeginQuery(GL_VERTICES_SUBMITTED_ARB, vertices_.id());
  glBeginQuery(GL_PRIMITIVES_SUBMITTED_ARB, primitives_.id());
  glBeginQuery(GL_FRAGMENT_SHADER_INVOCATIONS_ARB, fragments_.id());
}

void RunMeter::end_queries() {
  if (!measures_) return;
  if (counts_pipeline_) {
    glEndQuery(GL_FRAGMENT_SHADER_INVOCATIONS_ARB);
    glEndQuery(GL_PRIMITIVES_SUBMITTED_ARB);
    glEndQuery(GL_VERTICES_SUBMITTED_ARB);
  }
  if (!wall_clock_) glEndQuery(GL_TIME_ELAPSED);
}

void RunMeter::end(PassResult& result) {
  if (!measures_) return;
  end_queries();
  if (wall_clock_) {
    glFinish();
    result.milliseconds = watch_.milliseconds();
  } else {
    result.milliseconds = static_cast<double>(answer(time_)) * 1e-6;
  }
  result.processor_milliseconds = watch_.processor_milliseconds();
  if (counts_pipeline_) {
    result.vertices = answer(vertices_);
    result.primitives = answer(primitives_);
    result.fragments = answer(fragments_);
  }
}

}  // namespace caustics::gl
