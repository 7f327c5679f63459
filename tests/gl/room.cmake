# Shader texts that only the tests of the OpenGL Device draw with.
caustics_add_shader(caustics_tests gl_fetch TEXT tests/gl/shaders/gl_fetch.glsl)
