# The program from outside: one test for each *_test.py here, in Python 3 without any package.
if(TARGET caustics_app)
  find_package(Python3 COMPONENTS Interpreter)
  if(Python3_Interpreter_FOUND)
    file(GLOB program_tests CONFIGURE_DEPENDS ${CMAKE_CURRENT_LIST_DIR}/*_test.py)
    foreach(test IN LISTS program_tests)
      get_filename_component(name ${test} NAME_WE)
      add_test(NAME program_${name} COMMAND Python3::Interpreter ${test})
      set_tests_properties(program_${name} PROPERTIES
        ENVIRONMENT "CAUSTICS_PROGRAM=$<TARGET_FILE:caustics_app>;PYTHONDONTWRITEBYTECODE=1"
        TIMEOUT 900 SKIP_RETURN_CODE 4 COST 1)
    endforeach()
    set_tests_properties(program_gl_test PROPERTIES COST 2)  # the longest, begun first
  else()
    message(STATUS "Python 3 not found: the program is not tested from outside")
  endif()
endif()
