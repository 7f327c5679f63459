# Shader texts that only the rasterizer's tests draw with.
caustics_add_shader(caustics_tests raster_probe TEXT tests/raster/shaders/raster_probe.glsl)
caustics_add_shader(caustics_tests raster_two_targets TEXT tests/raster/shaders/raster_two_targets.glsl)
caustics_add_shader(caustics_tests raster_discard TEXT tests/raster/shaders/raster_discard.glsl)
caustics_add_shader(caustics_tests raster_rectangles TEXT tests/raster/shaders/raster_rectangles.glsl)
caustics_add_shader(caustics_tests raster_kept TEXT tests/raster/shaders/raster_kept.glsl)
