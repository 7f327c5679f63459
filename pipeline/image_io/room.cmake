# caustics_image_io: images in and out. It loads libcaustics_image_io.so, the module that links OpenImageIO,
# when the first image is read or written that is no PNG or JPEG texture, nor a PNG to write.
find_package(OpenImageIO REQUIRED)
find_package(PNG REQUIRED)
# By its name: Debian's CMake files for it name a library of another package.
find_library(TURBOJPEG_LIBRARY turbojpeg REQUIRED)
# Debian 12's OpenImageIO names include folders (OpenCV's) that it does not depend on.
get_target_property(oiio_folders OpenImageIO::OpenImageIO INTERFACE_INCLUDE_DIRECTORIES)
set(oiio_existing "")
foreach(folder IN LISTS oiio_folders)
  if(EXISTS ${folder})
    list(APPEND oiio_existing ${folder})
  endif()
endforeach()
set_target_properties(OpenImageIO::OpenImageIO PROPERTIES INTERFACE_INCLUDE_DIRECTORIES "${oiio_existing}")

include(GNUInstallDirs)
set(CAUSTICS_MODULE_FOLDER ${CMAKE_INSTALL_LIBDIR}/caustics)

file(GLOB module_sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/pipeline/image_io/openimageio/*.cpp)
add_library(caustics_image_io_module MODULE ${module_sources})
set_target_properties(caustics_image_io_module PROPERTIES OUTPUT_NAME caustics_image_io
  LIBRARY_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR})
caustics_target_options(caustics_image_io_module)
caustics_batch(caustics_image_io_module)
target_include_directories(caustics_image_io_module PRIVATE ${PROJECT_SOURCE_DIR})
target_link_libraries(caustics_image_io_module PRIVATE OpenImageIO::OpenImageIO)
install(TARGETS caustics_image_io_module LIBRARY DESTINATION ${CAUSTICS_MODULE_FOLDER})

add_library(caustics_image_io STATIC pipeline/image_io/image_io.cpp pipeline/image_io/png_and_jpeg.cpp)
add_library(caustics::image_io ALIAS caustics_image_io)
caustics_target_options(caustics_image_io)
target_compile_definitions(caustics_image_io PRIVATE CAUSTICS_MODULE_FOLDER="${CAUSTICS_MODULE_FOLDER}"
  CAUSTICS_INSTALL_PREFIX="${CMAKE_INSTALL_PREFIX}" CAUSTICS_BUILD_FOLDER="${PROJECT_BINARY_DIR}")
target_link_libraries(caustics_image_io PUBLIC caustics_pipeline
  PRIVATE PNG::PNG turbojpeg ${CMAKE_DL_LIBS})
add_dependencies(caustics_image_io caustics_image_io_module)
