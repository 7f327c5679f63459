# Every room's tests in one program, and the tests that drive the program from outside.
find_package(Catch2 REQUIRED)
include(Catch)
find_package(Python3 REQUIRED COMPONENTS Interpreter)

file(GLOB_RECURSE caustics_test_sources CONFIGURE_DEPENDS
  ${PROJECT_SOURCE_DIR}/pipeline/*_test.cpp ${PROJECT_SOURCE_DIR}/passes/*_test.cpp
  ${PROJECT_SOURCE_DIR}/lab/*_test.cpp
  ${PROJECT_SOURCE_DIR}/tests/*_test.cpp)
if(NOT CAUSTICS_BUILD_APP)
  list(FILTER caustics_test_sources EXCLUDE REGEX "/tests/scene/|/lab/study/|/lab/paper/")
endif()
add_executable(caustics_tests ${caustics_test_sources})
target_sources(caustics_tests PRIVATE ${PROJECT_SOURCE_DIR}/tests/support/failing_new.cpp)
caustics_target_options(caustics_tests)
target_compile_options(caustics_tests PRIVATE $<$<CONFIG:Release>:-O1>)
if(CAUSTICS_SANITIZE)  # whose checks of optimised tests take the compiler three times as long
  target_compile_options(caustics_tests PRIVATE -O0)
  target_compile_definitions(caustics_tests PRIVATE CAUSTICS_SANITIZED)
  set_source_files_properties(${PROJECT_SOURCE_DIR}/tests/support/catch_main.cpp PROPERTIES
    COMPILE_OPTIONS -fno-sanitize=all)
endif()
target_precompile_headers(caustics_tests PRIVATE ${CAUSTICS_STANDARD_HEADERS}
  ${PROJECT_SOURCE_DIR}/tests/support/catch.hpp)
set_source_files_properties(${PROJECT_SOURCE_DIR}/tests/support/catch_main.cpp PROPERTIES
  SKIP_PRECOMPILE_HEADERS ON)
target_link_libraries(caustics_tests PRIVATE caustics_passes caustics_raster caustics_gl_backend
  caustics_reference caustics_metrics
  caustics_pipeline)
if(CAUSTICS_BUILD_APP)
  target_link_libraries(caustics_tests PRIVATE caustics_gltf caustics_study caustics_paper
    nlohmann_json::nlohmann_json)
endif()

# caustics_skip_tests(SOURCE CAUSE): leaves a test's source out, and tells CTest of each of its tests that it
# is skipped, and why.
function(caustics_skip_tests source cause)
  get_target_property(sources caustics_tests SOURCES)
  list(REMOVE_ITEM sources ${source})
  set_target_properties(caustics_tests PROPERTIES SOURCES "${sources}")
  file(READ ${source} text)
  string(REGEX MATCHALL "TEST_CASE\\([ \n]*\"[^\"]*" cases "${text}")
  foreach(case IN LISTS cases)
    string(REGEX REPLACE "^[^\"]*\"" "" name "${case}")
    add_test(NAME "${name}" COMMAND ${CMAKE_COMMAND} -E echo "skipped: ${cause}")
    set_tests_properties("${name}" PROPERTIES SKIP_REGULAR_EXPRESSION "^skipped: ")
  endforeach()
endfunction()

# Random scenes need RapidCheck; a machine without it tests the rest.
find_package(rapidcheck CONFIG QUIET)
if(TARGET rapidcheck)
  target_link_libraries(caustics_tests PRIVATE rapidcheck)
else()
  caustics_skip_tests(${PROJECT_SOURCE_DIR}/tests/stability/random_scenes_test.cpp "no RapidCheck")
endif()
file(GLOB hard_cases CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/tests/stability/*_cases.cpp)
target_sources(caustics_tests PRIVATE ${hard_cases} ${PROJECT_SOURCE_DIR}/tests/stability/hard_case.cpp)
foreach(decoder IN ITEMS draco:DRACO:draco meshopt:MESHOPT:meshoptimizer)
  string(REGEX MATCH "(.*):(.*):(.*)" decoder ${decoder})
  if(CAUSTICS_HAS_${CMAKE_MATCH_2})
    target_link_libraries(caustics_tests PRIVATE ${CMAKE_MATCH_3}::${CMAKE_MATCH_3})
  elseif(CAUSTICS_BUILD_APP)
    caustics_skip_tests(${PROJECT_SOURCE_DIR}/tests/scene/load_${CMAKE_MATCH_1}_test.cpp
      "no ${CMAKE_MATCH_3}")
  endif()
endforeach()
target_link_libraries(caustics_tests PRIVATE Catch2::Catch2)
target_sources(caustics_tests PRIVATE ${PROJECT_SOURCE_DIR}/tests/support/catch_main.cpp)
include(${PROJECT_SOURCE_DIR}/tests/raster/room.cmake OPTIONAL)
include(${PROJECT_SOURCE_DIR}/tests/gl/room.cmake OPTIONAL)
include(${PROJECT_SOURCE_DIR}/tests/parity/room.cmake OPTIONAL)
include(${PROJECT_SOURCE_DIR}/tests/walk/room.cmake OPTIONAL)
caustics_batch_apart(caustics_tests 10)
# kSkippedExit of tests/support/skip.hpp; Catch2 3's own code too.
catch_discover_tests(caustics_tests PROPERTIES SKIP_RETURN_CODE 4)

add_test(NAME determinism.matrix
  COMMAND Python3::Interpreter ${PROJECT_SOURCE_DIR}/tests/determinism/matrix_test.py)
foreach(rule include_arrows unnamed_names test_names shader_functions passes pages format)
  add_test(NAME architecture.${rule}
    COMMAND Python3::Interpreter ${PROJECT_SOURCE_DIR}/tests/architecture/${rule}.py)
endforeach()
add_test(NAME architecture.uniform_structs
  COMMAND ${CMAKE_COMMAND} -P ${PROJECT_SOURCE_DIR}/tests/architecture/uniform_structs.cmake)
add_test(NAME architecture.headers_compile_alone
  COMMAND Python3::Interpreter ${PROJECT_SOURCE_DIR}/tests/architecture/headers.py ${CMAKE_CXX_COMPILER})
add_test(NAME architecture.shaders_are_precise_glsl
  COMMAND Python3::Interpreter ${PROJECT_SOURCE_DIR}/tests/architecture/shaders.py
    $<TARGET_FILE:caustics_shader_texts>)
add_test(NAME architecture.faults
  COMMAND Python3::Interpreter ${PROJECT_SOURCE_DIR}/tests/faults/faults.py)
set_tests_properties(architecture.format architecture.shaders_are_precise_glsl PROPERTIES
  SKIP_RETURN_CODE 77)
# Begun early, since they are long; as those in tests/program.
set_tests_properties(architecture.headers_compile_alone architecture.shaders_are_precise_glsl
  PROPERTIES COST 1)
if(CAUSTICS_BUILD_APP)
  include(${PROJECT_SOURCE_DIR}/tests/program/room.cmake OPTIONAL)
  include(${PROJECT_SOURCE_DIR}/tests/inspect/room.cmake OPTIONAL)
endif()
include(${PROJECT_SOURCE_DIR}/tests/package/room.cmake OPTIONAL)
