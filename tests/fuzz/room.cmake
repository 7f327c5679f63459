# Fuzzers, built with -DCAUSTICS_BUILD_FUZZERS=ON and clang (tests/fuzz/run does it); and, with the tests, the
# same entry points behind a main that runs every file of the committed corpus.

# caustics_add_fuzz_target(NAME SOURCE ...): linked to what the entry points need.
function(caustics_add_fuzz_target name)
  list(TRANSFORM ARGN PREPEND ${PROJECT_SOURCE_DIR}/tests/fuzz/ OUTPUT_VARIABLE sources)
  add_executable(${name} ${sources})
  caustics_target_options(${name})
  target_link_libraries(${name} PRIVATE caustics_gltf caustics_pipeline caustics_passes caustics_raster)
endfunction()

set(fuzz_load load_fuzzer.cpp fuzzed_scene.cpp)
set(fuzz_render render_fuzzer.cpp fuzzed_scene.cpp tiny_frame.cpp)
set(fuzz_image image_fuzzer.cpp fuzzed_scene.cpp)
set(fuzz_tail_load 0)
set(fuzz_tail_render 8)  # bytes that choose settings: kSettingsBytes

# The corpus is one archive; CAUSTICS_FUZZ_CORPUS has it in files, anew whenever it changes.
set(CAUSTICS_FUZZ_CORPUS ${PROJECT_BINARY_DIR}/fuzz_corpus)
add_custom_command(OUTPUT ${CAUSTICS_FUZZ_CORPUS}.unpacked
  COMMAND ${CMAKE_COMMAND} -E rm -rf ${CAUSTICS_FUZZ_CORPUS}
  COMMAND ${CMAKE_COMMAND} -E make_directory ${CAUSTICS_FUZZ_CORPUS}
  COMMAND ${CMAKE_COMMAND} -E chdir ${CAUSTICS_FUZZ_CORPUS}
    ${CMAKE_COMMAND} -E tar xf ${PROJECT_SOURCE_DIR}/tests/fuzz/corpus.zip
  COMMAND ${CMAKE_COMMAND} -E touch ${CAUSTICS_FUZZ_CORPUS}.unpacked
  DEPENDS ${PROJECT_SOURCE_DIR}/tests/fuzz/corpus.zip
  COMMENT "Unpacking the fuzz corpus")
add_custom_target(caustics_fuzz_corpus ALL DEPENDS ${CAUSTICS_FUZZ_CORPUS}.unpacked)

foreach(entry load image render)
  if(CAUSTICS_BUILD_FUZZERS)
    caustics_add_fuzz_target(fuzz_${entry} ${fuzz_${entry}})
    if(NOT entry STREQUAL "image")
      target_sources(fuzz_${entry} PRIVATE ${PROJECT_SOURCE_DIR}/tests/fuzz/mutate_gltf.cpp)
      set(tail ${fuzz_tail_${entry}})
      target_compile_definitions(fuzz_${entry} PRIVATE CAUSTICS_FUZZ_TAIL=${tail})
    endif()
    target_link_options(fuzz_${entry} PRIVATE -fsanitize=fuzzer)
    add_dependencies(fuzz_${entry} caustics_fuzz_corpus)
  endif()
  if(CAUSTICS_BUILD_TESTS)
    caustics_add_fuzz_target(replay_${entry} ${fuzz_${entry}} replay_main.cpp)
    add_dependencies(replay_${entry} caustics_fuzz_corpus)
    add_test(NAME fuzz.corpus_${entry} COMMAND replay_${entry} ${CAUSTICS_FUZZ_CORPUS}/${entry})
    set_tests_properties(fuzz.corpus_${entry} PROPERTIES TIMEOUT 300)
  endif()
endforeach()
if(CAUSTICS_BUILD_TESTS)
  add_test(NAME fuzz.corpus_is_what_its_script_makes
    COMMAND Python3::Interpreter ${PROJECT_SOURCE_DIR}/tests/fuzz/make_corpus.py --check)
endif()

if(CAUSTICS_BUILD_FUZZERS)
  # Any file under the limits of the program: tests/fuzz/run FOLDER.
  caustics_add_fuzz_target(fuzz_try try_main.cpp fuzzed_scene.cpp tiny_frame.cpp)
  add_custom_target(fuzzers DEPENDS fuzz_load fuzz_render fuzz_image fuzz_try)
endif()
