# caustics_digest: `caustics digest` alone, for builds and machines to compare (matrix.py). Built when it is asked for.
find_package(CLI11 REQUIRED)
set(digest_sources tests/determinism/digest_program.cpp)
foreach(file attachments backend digest frame frame_options interrupt judged_scene parser run_program sample_scenes terminal)
  list(APPEND digest_sources app/${file}.cpp)
endforeach()
add_executable(caustics_digest EXCLUDE_FROM_ALL ${digest_sources})
caustics_target_options(caustics_digest)
target_link_libraries(caustics_digest PRIVATE caustics_passes caustics_raster caustics_gl_backend caustics_gltf CLI11::CLI11)
