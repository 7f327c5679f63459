# The page of `caustics inspect` in a browser. Debian's Python has Debian's selenium.
if(TARGET caustics_app)
  find_program(CAUSTICS_SYSTEM_PYTHON python3 PATHS /usr/bin NO_DEFAULT_PATH)
  if(CAUSTICS_SYSTEM_PYTHON)
    foreach(name inspect_page page_shown written_page)
      add_test(NAME ${name} COMMAND ${CAUSTICS_SYSTEM_PYTHON} ${CMAKE_CURRENT_LIST_DIR}/${name}_test.py)
      set_tests_properties(${name} PROPERTIES
        ENVIRONMENT "CAUSTICS_PROGRAM=$<TARGET_FILE:caustics_app>;PYTHONDONTWRITEBYTECODE=1"
        TIMEOUT 900 SKIP_RETURN_CODE 4 COST 1)
    endforeach()
  endif()
endif()
