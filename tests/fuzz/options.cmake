# How everything is compiled where the fuzzers are: coverage for libFuzzer, and both sanitizers, whose every
# finding ends the program. Only the lanes that every processor has, and one thread where nothing else is
# built: less to compile, and the same bits.
if(NOT CMAKE_CXX_COMPILER_ID MATCHES "Clang")
  message(FATAL_ERROR "CAUSTICS_BUILD_FUZZERS needs clang: add -DCMAKE_CXX_COMPILER=clang++")
endif()
set(CAUSTICS_SANITIZE fuzzer-no-link,address,undefined)
set(CAUSTICS_LANES plain)
if(NOT CAUSTICS_BUILD_APP)
  set(CMAKE_DISABLE_FIND_PACKAGE_TBB ON)
  set(CMAKE_DISABLE_FIND_PACKAGE_embree ON)  # it needs oneTBB
endif()
