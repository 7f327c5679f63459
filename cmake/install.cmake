# Installing the libraries, so that another project can say find_package(caustics); the config file says what
# it then has. The program and the sample scenes are installed by app/room.cmake.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(libraries pipeline passes raster gl_backend reference metrics)
set(CAUSTICS_HAS_GLTF FALSE)
if(TARGET caustics_gltf AND TARGET caustics_image_io)
  set(CAUSTICS_HAS_GLTF TRUE)
endif()
set(config_folder ${CMAKE_INSTALL_LIBDIR}/cmake/caustics)

foreach(library IN LISTS libraries)
  set(folder ${library})
  if(library MATCHES "^(reference|metrics)$")
    set(folder lab/${library})
  endif()
  set_target_properties(caustics_${library} PROPERTIES EXPORT_NAME ${library})
  install(TARGETS caustics_${library} EXPORT caustics-targets
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
  # Headers, and the texts of the shader subset, which pass authors include.
  cmake_path(GET folder PARENT_PATH parent)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/${folder}
    DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/caustics/${parent}
    FILES_MATCHING PATTERN *.hpp PATTERN *.glsl
    PATTERN gltf EXCLUDE PATTERN openimageio EXCLUDE PATTERN lanes EXCLUDE PATTERN template EXCLUDE
    # Of the OpenGL device only what its users need.
    PATTERN egl_context.hpp EXCLUDE
    PATTERN precise_text.hpp EXCLUDE
    REGEX "gl_(debug|framebuffer|mesh|meter|object|program|state|text|texture|uniforms)\\.hpp$" EXCLUDE)
endforeach()

if(CAUSTICS_HAS_GLTF)
  foreach(library IN ITEMS gltf image_io)
    set_target_properties(caustics_${library} PROPERTIES EXPORT_NAME ${library})
    install(TARGETS caustics_${library} EXPORT caustics-targets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
  endforeach()
  install(FILES pipeline/scene/gltf/load_gltf.hpp pipeline/scene/gltf/load_environment.hpp
    DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/caustics/pipeline/scene/gltf)
endif()

set(CAUSTICS_HAS_TBB FALSE)
if(TARGET TBB::tbb)
  set(CAUSTICS_HAS_TBB TRUE)
endif()

set(CAUSTICS_HAS_EPOXY FALSE)
if(TARGET PkgConfig::EPOXY)
  set(CAUSTICS_HAS_EPOXY TRUE)
endif()

install(EXPORT caustics-targets NAMESPACE caustics:: DESTINATION ${config_folder})
configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/caustics-config.cmake.in
  ${PROJECT_BINARY_DIR}/caustics-config.cmake INSTALL_DESTINATION ${config_folder}
  PATH_VARS CMAKE_INSTALL_INCLUDEDIR)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/caustics-config-version.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES cmake/shaders.cmake cmake/kernel.cpp.in cmake/shader.cpp.in DESTINATION ${config_folder})
install(FILES ${PROJECT_BINARY_DIR}/caustics-config.cmake
  ${PROJECT_BINARY_DIR}/caustics-config-version.cmake DESTINATION ${config_folder})
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})
