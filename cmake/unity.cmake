option(CAUSTICS_UNITY_BUILD
  "Compile sources in batches: faster whole builds, slower small changes" OFF)

set(CAUSTICS_UNITY_BATCH 8 CACHE STRING "Sources of a batch")

# Names in unnamed namespaces must differ, all over a target: batches are cut anew when a file is added.
function(caustics_batch target)
  if(CAUSTICS_UNITY_BUILD)
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE ${CAUSTICS_UNITY_BATCH})
  endif()
endfunction()

# caustics_batch_apart(target size): of a target's tests, which choose names as if they stood alone. A batch
# includes the headers of all, then each in a namespace of its own; tests that open a named one are left out.
function(caustics_batch_apart target size)
  if(NOT CAUSTICS_UNITY_BUILD)
    return()
  endif()
  get_target_property(sources ${target} SOURCES)
  list(FILTER sources INCLUDE REGEX "_test\\.cpp$")
  set(apart "")
  foreach(source IN LISTS sources)
    file(READ ${source} text)
    if(NOT text MATCHES "\nnamespace [a-z]")
      list(APPEND apart ${source})
    endif()
  endforeach()
  list(LENGTH apart count)
  foreach(first RANGE 0 ${count} ${size})
    if(first LESS count)
      list(SUBLIST apart ${first} ${size} sources)
      set(batch ${CMAKE_CURRENT_BINARY_DIR}/batches/${target}_${first}.cpp)
      add_custom_command(OUTPUT ${batch} VERBATIM COMMENT ""
        COMMAND ${CMAKE_COMMAND} -DBATCH=${batch} "-DSOURCES=${sources}" -P ${CAUSTICS_CMAKE_DIR}/batch.cmake
        DEPENDS ${sources} ${CAUSTICS_CMAKE_DIR}/batch.cmake)
      target_sources(${target} PRIVATE ${batch})
      set_source_files_properties(${sources} PROPERTIES HEADER_FILE_ONLY ON)
    endif()
  endforeach()
endfunction()
