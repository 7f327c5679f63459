# cmake -P: the build holds the layout of uniform structs against std140's, and of no struct that varies.
include(${CMAKE_CURRENT_LIST_DIR}/../../cmake/shaders.cmake)
caustics_uniform_checks("
struct Box { vec3 lower; vec3 upper; };
struct Boxes { Box near; Box far; };
struct Ray { Vec3 origin; Vec3 direction; };
struct Meeting { Ray ray; Box box; };
struct Meetings { Meeting first; Meeting last; };
" checks)
foreach(uniform Box Boxes)
  if(NOT checks MATCHES "bool ${uniform}_follows_std140")
    message(FATAL_ERROR "the layout of ${uniform}, which is uniform, is not checked")
  endif()
endforeach()
foreach(varying Ray Meeting Meetings)
  if(checks MATCHES "bool ${varying}_follows_std140")
    message(FATAL_ERROR "${varying} varies, and is taken for a uniform struct")
  endif()
endforeach()
