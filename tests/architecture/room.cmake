# What holds of the source text itself: which room may include which, that headers stand alone, and that
# GLSL accepts every shader. Python 3 without any package.
if(NOT Python3_Interpreter_FOUND)
  message(STATUS "Python 3 not found: the architecture is not tested")
  return()
endif()

function(caustics_add_architecture_test name)
  add_test(NAME architecture.${name}
    COMMAND Python3::Interpreter ${PROJECT_SOURCE_DIR}/tests/architecture/${name}_test.py ${ARGN})
  set_tests_properties(architecture.${name} PROPERTIES LABELS architecture TIMEOUT 900
    SKIP_RETURN_CODE 77 ENVIRONMENT PYTHONDONTWRITEBYTECODE=1)
endfunction()

set(include_flags "")
if(TARGET OpenImageIO::OpenImageIO)
  get_target_property(folders OpenImageIO::OpenImageIO INTERFACE_INCLUDE_DIRECTORIES)
  foreach(folder IN LISTS folders)
    list(APPEND include_flags -isystem ${folder})
  endforeach()
endif()

caustics_add_architecture_test(includes)
caustics_add_architecture_test(headers ${CMAKE_CXX_COMPILER} ${include_flags})
set_tests_properties(architecture.headers PROPERTIES RUN_SERIAL TRUE)
find_program(GLSLANG_VALIDATOR NAMES glslangValidator glslang)
if(GLSLANG_VALIDATOR)
  caustics_add_architecture_test(glsl ${GLSLANG_VALIDATOR})
else()
  message(STATUS "glslangValidator not found: the GLSL of the shaders is not tested")
endif()
