# Shader texts that show parts of the pass walk by themselves.
caustics_add_shader(caustics_tests walk_enter TEXT tests/walk/shaders/walk_enter.glsl)
caustics_add_shader(caustics_tests walk_bend TEXT tests/walk/shaders/walk_bend.glsl)
caustics_add_shader(caustics_tests walk_land TEXT tests/walk/shaders/walk_land.glsl)
caustics_add_shader(caustics_tests walk_hit TEXT tests/walk/shaders/walk_hit.glsl)
