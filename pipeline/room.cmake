# caustics_gltf: scenes from glTF files and environments from images. Apart from caustics_pipeline,
# so that the core builds with a compiler and GLM alone.
if(CAUSTICS_BUILD_APP OR CAUSTICS_BUILD_TESTS OR CAUSTICS_BUILD_DIGEST OR CAUSTICS_BUILD_FUZZERS)
  find_package(nlohmann_json 3 REQUIRED)
  option(CAUSTICS_TINYGLTF_HEADER_ONLY "Compile tinygltf's header even if there is a library" OFF)
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
  target_precompile_headers(caustics_gltf PRIVATE ${CAUSTICS_STANDARD_HEADERS} <nlohmann/json.hpp>)
  target_link_libraries(caustics_gltf PUBLIC caustics_pipeline
    PRIVATE nlohmann_json::nlohmann_json $<TARGET_NAME_IF_EXISTS:caustics_image_io>)

  # Debian and Ubuntu ship tinygltf as a shared library; elsewhere it is a header to be compiled
  # once. The name of its target differs between versions.
  if(NOT CAUSTICS_TINYGLTF_HEADER_ONLY)
    find_package(TinyGLTF QUIET)
    foreach(candidate TinyGLTF::TinyGLTF tinygltf::tinygltf TinyGLTF tinygltf)
      if(TARGET ${candidate} AND NOT tinygltf_target)
        get_target_property(tinygltf_kind ${candidate} TYPE)
        if(NOT tinygltf_kind STREQUAL INTERFACE_LIBRARY)
          set(tinygltf_target ${candidate})
        endif()
      endif()
    endforeach()
  endif()
  if(tinygltf_target)
    target_link_libraries(caustics_gltf PRIVATE ${tinygltf_target})
  else()
    find_path(TINYGLTF_INCLUDE_DIR tiny_gltf.h PATH_SUFFIXES tinygltf REQUIRED)
    set(tinygltf_source ${CMAKE_CURRENT_BINARY_DIR}/tinygltf.cpp)
    file(WRITE ${tinygltf_source} "#define TINYGLTF_IMPLEMENTATION\n#include <tiny_gltf.h>\n")
    set_source_files_properties(${tinygltf_source} PROPERTIES COMPILE_OPTIONS -w)
    target_sources(caustics_gltf PRIVATE ${tinygltf_source})
    target_include_directories(caustics_gltf SYSTEM PRIVATE ${TINYGLTF_INCLUDE_DIR})
    # We decode images ourselves. These change the class's layout, so they hold for all sources.
    target_compile_definitions(caustics_gltf PRIVATE TINYGLTF_NO_STB_IMAGE
      TINYGLTF_NO_STB_IMAGE_WRITE TINYGLTF_NO_EXTERNAL_IMAGE)
  endif()
endif()
