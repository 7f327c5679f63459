# caustics_gltf: scenes from glTF files and environments from images. Apart from caustics_pipeline,
# so that the core builds with a compiler and GLM alone.
if(CAUSTICS_BUILD_APP OR CAUSTICS_BUILD_TESTS OR CAUSTICS_BUILD_DIGEST OR CAUSTICS_BUILD_FUZZERS)
  find_package(nlohmann_json 3 REQUIRED)
  # For digests on machines without OpenImageIO; the program itself needs it.
  option(CAUSTICS_PLAIN_PNG "Decode PNG files of 8 bits by tests/determinism/plain_png.cpp, and no others"
    OFF)

  file(GLOB gltf_sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/pipeline/scene/gltf/*.cpp)
  if(CAUSTICS_PLAIN_PNG)
    list(FILTER gltf_sources EXCLUDE REGEX "/image_file[.]cpp$")
    list(APPEND gltf_sources ${PROJECT_SOURCE_DIR}/tests/determinism/plain_png.cpp)
  else()
    include(pipeline/image_io/room.cmake)
  endif()
  add_library(caustics_gltf STATIC pipeline/scene/gltf/load_gltf.cpp ${gltf_sources})
  add_library(caustics::gltf ALIAS caustics_gltf)
  caustics_target_options(caustics_gltf)
  caustics_batch(caustics_gltf)
  caustics_precompile(caustics_gltf caustics_pipeline)
  target_link_libraries(caustics_gltf PUBLIC caustics_pipeline
    PRIVATE nlohmann_json::nlohmann_json)
  if(TARGET caustics_image_io)
    target_link_libraries(caustics_gltf PRIVATE caustics_image_io)
  endif()
  # What unpacks compressed geometry; without it such files are refused.
  find_package(draco CONFIG QUIET)
  find_package(meshoptimizer CONFIG QUIET)
  foreach(decoder IN ITEMS draco:DRACO meshoptimizer:MESHOPT)
    string(REGEX MATCH "(.*):(.*)" decoder ${decoder})
    set(CAUSTICS_HAS_${CMAKE_MATCH_2} FALSE)
    if(TARGET ${CMAKE_MATCH_1}::${CMAKE_MATCH_1})
      set(CAUSTICS_HAS_${CMAKE_MATCH_2} TRUE)
      target_link_libraries(caustics_gltf PRIVATE ${CMAKE_MATCH_1}::${CMAKE_MATCH_1})
      target_compile_definitions(caustics_gltf PRIVATE CAUSTICS_HAS_${CMAKE_MATCH_2}=1)
    else()
      message(STATUS "${CMAKE_MATCH_1} not found: glTF files that need it will be refused")
    endif()
  endforeach()
  set_source_files_properties(pipeline/scene/gltf/draco.cpp pipeline/scene/gltf/meshopt.cpp PROPERTIES
    SKIP_PRECOMPILE_HEADERS ON SKIP_UNITY_BUILD_INCLUSION ON)
endif()
