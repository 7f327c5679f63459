# Shader texts that only the tests of the OpenGL Device draw with.
caustics_add_shader(caustics_tests gl_fetch TEXT tests/gl/shaders/gl_fetch.glsl)

# What the driver is given for every registered shader, for tests/architecture/shaders.py.
add_executable(caustics_shader_texts ${PROJECT_SOURCE_DIR}/tests/gl/shader_texts_program.cpp)
caustics_target_options(caustics_shader_texts)
target_link_libraries(caustics_shader_texts PRIVATE caustics_passes caustics_gl_backend)

# A driver that fails at will leads every function that the backend calls through itself (faulty_driver.hpp):
# their names, from the backend's sources.
if(TARGET PkgConfig::EPOXY)
  file(GLOB gl_backend_files CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/gl_backend/*.cpp
    ${PROJECT_SOURCE_DIR}/gl_backend/*.hpp)
  set(driver_calls "")
  foreach(file ${gl_backend_files})
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
    file(READ ${file} text)
    string(REGEX MATCHALL "[ \n\t(!&](egl|gl)[A-Z][A-Za-z0-9]+[(]" calls "${text}")
    foreach(call ${calls})
      string(REGEX REPLACE "^.([A-Za-z0-9]+)[(]$" "CALL(\\1)" call "${call}")
      list(APPEND driver_calls "${call}")
    endforeach()
  endforeach()
  list(REMOVE_DUPLICATES driver_calls)
  list(SORT driver_calls)
  list(JOIN driver_calls "\n" driver_calls)
  file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/tests/gl/driver_calls.inc CONTENT "${driver_calls}\n")
  target_sources(caustics_tests PRIVATE ${PROJECT_SOURCE_DIR}/tests/gl/faulty_driver.cpp)
  set_source_files_properties(${PROJECT_SOURCE_DIR}/tests/gl/faulty_driver.cpp PROPERTIES
    INCLUDE_DIRECTORIES ${PROJECT_BINARY_DIR}/tests/gl)
  target_link_libraries(caustics_tests PRIVATE PkgConfig::EPOXY)
else()
  caustics_skip_tests(${PROJECT_SOURCE_DIR}/tests/gl/driver_faults_test.cpp
    "no OpenGL: built without libepoxy")
endif()
