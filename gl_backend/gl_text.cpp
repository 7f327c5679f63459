#include "gl_backend/gl_text.hpp"

#include "gl_backend/precise_text.hpp"

namespace caustics::gl {

std::string gl_text(const Shader& shader, Stage stage) {
  const std::string macro = stage == Stage::Vertex ? "VERTEX_STAGE" : "FRAGMENT_STAGE";
  return precise_text("#version 450 core\n#define " + macro + " 1\n" + std::string(kPrelude) + "\n#line 1\n" +
                      std::string(shader.text));
}

}  // namespace caustics::gl
