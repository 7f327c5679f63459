# One line for each shader text: caustics_add_shader(caustics_passes <name> TEXT <path>)
caustics_add_shader(caustics_passes copy TEXT passes/template/copy.glsl)
