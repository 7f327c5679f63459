# The program `caustics`.
# pipeline/room.cmake has found nlohmann_json.
find_package(CLI11 REQUIRED)
find_package(PNG REQUIRED)
find_package(ZLIB REQUIRED)

file(GLOB_RECURSE app_sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/app/*.cpp)
list(FILTER app_sources EXCLUDE REGEX "_test[.]cpp$")
add_executable(caustics_app ${app_sources})
set_target_properties(caustics_app PROPERTIES OUTPUT_NAME caustics)
caustics_target_options(caustics_app ONCE)
caustics_batch(caustics_app)
caustics_precompile(caustics_app caustics_app)
# A large part of the first build, and no part of a frame.
set_source_files_properties(app/json.cpp PROPERTIES COMPILE_OPTIONS -O0 SKIP_PRECOMPILE_HEADERS ON
  SKIP_UNITY_BUILD_INCLUSION ON)
target_link_libraries(caustics_app PRIVATE caustics_passes caustics_raster caustics_gl_backend caustics_gltf
  caustics_reference caustics_metrics caustics_study caustics_paper
  caustics_image_io PNG::PNG ZLIB::ZLIB nlohmann_json::nlohmann_json CLI11::CLI11)
target_compile_definitions(caustics_app PRIVATE CAUSTICS_VERSION="${PROJECT_VERSION}")
if(TARGET TBB::tbb)
  target_compile_definitions(caustics_app PRIVATE CAUSTICS_TBB_VERSION="${TBB_VERSION}")
endif()

include(app/inspect/room.cmake)

include(GNUInstallDirs)
install(TARGETS caustics_app RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
# What the program prints of itself, where man and the shells look for it.
foreach(form IN ITEMS man:man/man1/caustics.1 bash:bash-completion/completions/caustics
    zsh:zsh/site-functions/_caustics fish:fish/vendor_completions.d/caustics.fish)
  string(REPLACE ":" ";" form ${form})
  list(GET form 0 name)
  list(GET form 1 place)
  cmake_path(GET place PARENT_PATH folder)
  set(share "\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_DATADIR}")
  install(CODE "file(MAKE_DIRECTORY \"${share}/${folder}\")
    execute_process(COMMAND \"$<TARGET_FILE:caustics_app>\" completion ${name}
      OUTPUT_FILE \"${share}/${place}\"
      COMMAND_ERROR_IS_FATAL ANY)")
endforeach()
install(DIRECTORY ${PROJECT_SOURCE_DIR}/scenes/ DESTINATION ${CMAKE_INSTALL_DATADIR}/caustics/scenes
  FILES_MATCHING PATTERN *.glb PATTERN *.gltf PATTERN *.bin PATTERN *.png PATTERN *.jpg)
