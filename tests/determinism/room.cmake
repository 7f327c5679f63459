# caustics_digest: `caustics digest` alone, for builds and machines to compare (matrix.py).
# caustics_pass_times: what equal bits cost (price.sh). Built when they are asked for.
find_package(CLI11 REQUIRED)
set(frame_sources "")
foreach(file backend flux frame frame_memory frame_options loaded_scene output/light_groups shell/help_page
    shell/interrupt shell/parser shell/progress
    shell/run_program shell/setting_options shell/terminal)
  list(APPEND frame_sources app/${file}.cpp)
endforeach()
add_library(caustics_frame STATIC EXCLUDE_FROM_ALL ${frame_sources})
caustics_target_options(caustics_frame)
target_link_libraries(caustics_frame PUBLIC caustics_passes caustics_raster caustics_gl_backend
  caustics_gltf CLI11::CLI11)

add_executable(caustics_digest EXCLUDE_FROM_ALL tests/determinism/digest_program.cpp
  app/output/attachments.cpp app/digest.cpp app/sample_scenes.cpp)
add_executable(caustics_pass_times EXCLUDE_FROM_ALL tests/determinism/pass_times_program.cpp)
foreach(program caustics_digest caustics_pass_times)
  caustics_target_options(${program})
  target_link_libraries(${program} PRIVATE caustics_frame)
endforeach()
