# CAUSTICS_WIDTHS: the lane widths that shaders are compiled for, of CAUSTICS_ALL_WIDTHS, which stand in the
# order of `enum class Lanes`. The scalar one is always among them: probe follows single rays with it.
# all: what this architecture has; native: scalar and this processor's widest; plain: scalar and 4 lanes,
# which every processor has.
set(CAUSTICS_LANES all CACHE STRING "Lane widths to compile: all, native or plain")
set_property(CACHE CAUSTICS_LANES PROPERTY STRINGS all native plain)

set(CAUSTICS_ALL_WIDTHS scalar plain4 sse41 avx2 avx512)
if(NOT CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64" OR CAUSTICS_LANES STREQUAL "plain")
  set(CAUSTICS_WIDTHS scalar plain4)
else()
  set(CAUSTICS_WIDTHS ${CAUSTICS_ALL_WIDTHS})
endif()
if(CAUSTICS_LANES STREQUAL "native" AND EXISTS /proc/cpuinfo)
  file(STRINGS /proc/cpuinfo processor REGEX "^flags" LIMIT_COUNT 1)
  set(native plain4)
  foreach(width_and_flags IN ITEMS "sse41:sse4_1" "avx2:avx2,fma"
      "avx512:avx512f,avx512dq,avx512vl,avx512bw,fma")
    string(REGEX MATCHALL "[^:,]+" needed ${width_and_flags})
    list(POP_FRONT needed width)
    set(usable TRUE)
    foreach(flag IN LISTS needed)
      if(NOT "${processor} " MATCHES " ${flag} ")
        set(usable FALSE)
      endif()
    endforeach()
    if(usable AND width IN_LIST CAUSTICS_WIDTHS)
      set(native ${width})
    endif()
  endforeach()
  set(CAUSTICS_WIDTHS scalar ${native})
endif()
message(STATUS "lane widths: ${CAUSTICS_WIDTHS}")
