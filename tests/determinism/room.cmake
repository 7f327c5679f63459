# caustics_digest: `caustics digest` alone, for builds and machines to compare (matrix.py).
# caustics_pass_times: what equal bits cost (price.sh). Built when they are asked for.
find_package(CLI11 REQUIRED)

# The given sources, and those of the app whose headers they include, directly or not.
function(caustics_with_included_sources result)
  set(found ${ARGN})
  set(rest ${ARGN})
  while(rest)
    list(POP_FRONT rest file)
    file(STRINGS ${PROJECT_SOURCE_DIR}/${file} includes REGEX "^#include \"app/")
    string(REGEX MATCHALL "app/[a-z_/]+[.]hpp" headers "${includes}")
    string(REPLACE ".hpp" ".cpp" sources "${headers}")
    foreach(next IN LISTS headers sources)
      if(EXISTS ${PROJECT_SOURCE_DIR}/${next} AND NOT next IN_LIST found)
        list(APPEND found ${next})
        list(APPEND rest ${next})
      endif()
    endforeach()
  endwhile()
  set(${result} ${found} PARENT_SCOPE)
endfunction()

caustics_with_included_sources(frame_sources app/frame.cpp app/digest.cpp app/shell/run_program.cpp)
add_library(caustics_frame STATIC EXCLUDE_FROM_ALL ${frame_sources})
caustics_target_options(caustics_frame)
target_link_libraries(caustics_frame PUBLIC caustics_passes caustics_raster caustics_gl_backend
  caustics_gltf CLI11::CLI11)

foreach(program digest pass_times)
  add_executable(caustics_${program} EXCLUDE_FROM_ALL tests/determinism/${program}_program.cpp)
  caustics_target_options(caustics_${program})
  target_link_libraries(caustics_${program} PRIVATE caustics_frame)
endforeach()
