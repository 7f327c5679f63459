# Benchmarks, built with -DCAUSTICS_BUILD_BENCH=ON and run by hand on a quiet machine.
add_executable(raster_bench ${PROJECT_SOURCE_DIR}/tests/bench/raster_bench.cpp)
caustics_target_options(raster_bench)
target_link_libraries(raster_bench PRIVATE caustics_raster caustics_pipeline)
foreach(shader surface splat full_screen)
  caustics_add_shader(raster_bench bench_${shader} TEXT tests/bench/shaders/bench_${shader}.glsl)
endforeach()
