#include "pipeline/effects/bodies.hpp"

#include <map>
#include <utility>

namespace caustics {

std::vector<int> bodies_of(const Scene& scene) {
  std::vector<int> bodies;
  std::map<std::pair<int, int>, int> numbers;
  for (const Mesh& mesh : scene.meshes)
    bodies.push_back(
        numbers.try_emplace({mesh.object, mesh.material}, static_cast<int>(numbers.size())).first->second);
  return bodies;
}

}  // namespace caustics
