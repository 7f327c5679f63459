# Headers of libraries that most sources of a target include, parsed once. Sources include what they need all
# the same: clang-tidy compiles each by itself, without these.
set(CAUSTICS_STANDARD_HEADERS <algorithm> <array> <cmath> <cstdint> <filesystem> <functional> <glm/glm.hpp>
  <map> <memory> <optional> <span> <string> <string_view> <vector>)
