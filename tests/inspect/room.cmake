# The page of `caustics inspect` in a browser. Debian's Python has Debian's selenium.
if(TARGET caustics_app)
  find_program(CAUSTICS_SYSTEM_PYTHON python3 PATHS /usr/bin NO_DEFAULT_PATH)
  if(CAUSTICS_SYSTEM_PYTHON)
    add_test(NAME inspect_page COMMAND ${CAUSTICS_SYSTEM_PYTHON}
      ${CMAKE_CURRENT_LIST_DIR}/inspect_page_test.py)
    set_tests_properties(inspect_page PROPERTIES
      ENVIRONMENT "CAUSTICS_PROGRAM=$<TARGET_FILE:caustics_app>;PYTHONDONTWRITEBYTECODE=1"
      TIMEOUT 900 SKIP_RETURN_CODE 4 COST 1)
  endif()
endif()
