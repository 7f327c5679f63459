option(CAUSTICS_UNITY_BUILD
  "Compile sources in batches: faster whole builds, slower small changes" OFF)

# Names in unnamed namespaces must differ, all over a target: batches are cut anew when a file is added.
function(caustics_batch target)
  if(CAUSTICS_UNITY_BUILD)
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 8)
  endif()
endfunction()
