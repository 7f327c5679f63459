# Installing the libraries, so that another project can say find_package(caustics) and link
# caustics::raster, caustics::passes, caustics::pipeline and caustics::reference. They need GLM, and
# oneTBB where they were built with it. The program and the sample scenes are installed by app/room.cmake.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(libraries pipeline passes raster reference)
set(config_folder ${CMAKE_INSTALL_LIBDIR}/cmake/caustics)

foreach(library IN LISTS libraries)
  set_target_properties(caustics_${library} PROPERTIES EXPORT_NAME ${library})
  install(TARGETS caustics_${library} EXPORT caustics-targets
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
  # Headers, and the texts of the shader subset, which pass authors include.
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/${library}
    DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/caustics
    FILES_MATCHING PATTERN *.hpp PATTERN *.glsl
    PATTERN gltf EXCLUDE PATTERN lanes EXCLUDE PATTERN template EXCLUDE)
endforeach()

set(CAUSTICS_HAS_TBB FALSE)
if(TARGET TBB::tbb)
  set(CAUSTICS_HAS_TBB TRUE)
endif()

install(EXPORT caustics-targets NAMESPACE caustics:: DESTINATION ${config_folder})
configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/caustics-config.cmake.in
  ${PROJECT_BINARY_DIR}/caustics-config.cmake INSTALL_DESTINATION ${config_folder})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/caustics-config-version.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/caustics-config.cmake
  ${PROJECT_BINARY_DIR}/caustics-config-version.cmake DESTINATION ${config_folder})
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})
