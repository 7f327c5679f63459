# Headers of libraries that most sources of a target include, parsed once. Sources include what they need all
# the same: clang-tidy compiles each by itself, without these.
set(CAUSTICS_STANDARD_HEADERS <algorithm> <array> <cmath> <cstdint> <filesystem> <functional> <glm/glm.hpp>
  <map> <memory> <optional> <span> <string> <string_view> <vector>)

# caustics_precompile(target owner [HEADER ...]): target uses these headers as owner has parsed them, which
# must compile with the same options; owner itself parses them, and the headers named.
function(caustics_precompile target owner)
  if(target STREQUAL owner)
    target_precompile_headers(${target} PRIVATE ${CAUSTICS_STANDARD_HEADERS} ${ARGN})
  else()
    target_precompile_headers(${target} REUSE_FROM ${owner})
  endif()
endfunction()
