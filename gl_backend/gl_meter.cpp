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

RunMeter::RunMeter(bool timed, bool software_renderer)
    : timed_(timed),
      wall_clock_(timed && software_renderer),
      counts_pipeline_(timed && (epoxy_gl_version() >= 46 ||
                                 epoxy_has_gl_extension("GL_ARB_pipeline_statistics_query"))),
      time_(make_query()),
      samples_(make_query()) {
  if (!counts_pipeline_) return;
  vertices_ = make_query();
  primitives_ = make_query();
  fragments_ = make_query();
}

void RunMeter::begin(bool count_samples) {
  counts_samples_ = count_samples;
  if (wall_clock_) {
    glFinish();
    start_ = std::chrono::steady_clock::now();
  } else if (timed_) {
    glBeginQuery(GL_TIME_ELAPSED, time_.id());
  }
  if (counts_samples_) glBeginQuery(GL_SAMPLES_PASSED, samples_.id());
  if (!counts_pipeline_) return;
  glBeginQuery(GL_VERTICES_SUBMITTED_ARB, vertices_.id());
  glBeginQuery(GL_PRIMITIVES_SUBMITTED_ARB, primitives_.id());
  glBeginQuery(GL_FRAGMENT_SHADER_INVOCATIONS_ARB, fragments_.id());
}

void RunMeter::end_queries() {
  if (counts_pipeline_) {
    glEndQuery(GL_FRAGMENT_SHADER_INVOCATIONS_ARB);
    glEndQuery(GL_PRIMITIVES_SUBMITTED_ARB);
    glEndQuery(GL_VERTICES_SUBMITTED_ARB);
  }
  if (counts_samples_) glEndQuery(GL_SAMPLES_PASSED);
  if (timed_ && !wall_clock_) glEndQuery(GL_TIME_ELAPSED);
}

void RunMeter::end(PassResult& result) {
  end_queries();
  if (wall_clock_) {
    glFinish();
    result.milliseconds =
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start_)
            .count();
  } else if (timed_) {
    result.milliseconds = static_cast<double>(answer(time_)) * 1e-6;
  } else {
    glFlush();
  }
  if (counts_pipeline_) {
    result.vertices = answer(vertices_);
    result.primitives = answer(primitives_);
    result.fragments = answer(fragments_);
  }
  if (counts_samples_) result.samples_passed = answer(samples_);
}

}  // namespace caustics::gl
