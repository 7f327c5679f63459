#include "gl_backend/gl_occlusion.hpp"

namespace caustics::gl {

void OcclusionQueries::begin(OcclusionQuery query) {
  auto found = queries_.find(query);
  if (found == queries_.end()) {
    GLuint id = 0;
    glCreateQueries(GL_SAMPLES_PASSED, 1, &id);
    found = queries_.emplace(query, QueryObject(id)).first;
  }
  glBeginQuery(GL_SAMPLES_PASSED, found->second.id());
  counting_ = true;
}

void OcclusionQueries::end() {
  if (counting_) glEndQuery(GL_SAMPLES_PASSED);
  counting_ = false;
}

std::optional<std::uint64_t> OcclusionQueries::samples(OcclusionQuery query) const {
  const auto found = queries_.find(query);
  if (found == queries_.end()) return {};
  GLuint64 count = 0;
  glGetQueryObjectui64v(found->second.id(), GL_QUERY_RESULT, &count);
  return count;
}

void OcclusionQueries::begin_condition(OcclusionQuery query) {
  const auto found = queries_.find(query);
  if (found == queries_.end()) return;
  glBeginConditionalRender(found->second.id(), GL_QUERY_WAIT);
  conditional_ = true;
}

void OcclusionQueries::end_condition() {
  if (conditional_) glEndConditionalRender();
  conditional_ = false;
}

void OcclusionQueries::drop() {
  glEndConditionalRender();
  glEndQuery(GL_SAMPLES_PASSED);
  counting_ = conditional_ = false;
  queries_.clear();
}

}  // namespace caustics::gl
