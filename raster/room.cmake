# The tile renderer, compiled once for each instruction set. The scalar lanes share the plain one.
set(tile_kernels plain4 ${CAUSTICS_WIDTHS})
list(REMOVE_DUPLICATES tile_kernels)
list(REMOVE_ITEM tile_kernels scalar)
foreach(WIDTH IN LISTS tile_kernels)
  set(file ${PROJECT_BINARY_DIR}/raster/tile_kernel_${WIDTH}.cpp)
  configure_file(${PROJECT_SOURCE_DIR}/raster/lanes/tile_kernel.cpp.in ${file} @ONLY)
  set_source_files_properties(${file} PROPERTIES COMPILE_OPTIONS "${CAUSTICS_FLAGS_${WIDTH}};-Wno-psabi"
    SKIP_PRECOMPILE_HEADERS ON)
  target_sources(caustics_raster PRIVATE ${file})
endforeach()
list(TRANSFORM CAUSTICS_WIDTHS PREPEND CAUSTICS_COMPILES_ OUTPUT_VARIABLE compiles)
target_compile_definitions(caustics_raster PRIVATE ${compiles})
