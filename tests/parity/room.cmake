# Shader texts that only the parity tests draw with.
caustics_add_shader(caustics_tests torture TEXT tests/parity/shaders/torture.glsl)
caustics_add_shader(caustics_tests torture_points TEXT tests/parity/shaders/torture_points.glsl)
