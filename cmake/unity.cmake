option(CAUSTICS_UNITY_BUILD 
  "Compile the program's sources in batches: faster whole builds, slower small changes" OFF)

# Sources of a target that share large headers. Names in their unnamed namespaces must differ, all over the
# target: batches are cut anew when a file is added.
function(caustics_batch target)
  if(CAUSTICS_UNITY_BUILD)
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 8)
  endif()
endfunction()
