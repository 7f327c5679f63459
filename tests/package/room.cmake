# Another project can use what `cmake --install` puts down.
if(Python3_Interpreter_FOUND AND PROJECT_IS_TOP_LEVEL)
  set(consumer_flags "")
  if(CAUSTICS_SANITIZE)
    set(consumer_flags -fsanitize=${CAUSTICS_SANITIZE})
  endif()
  add_test(NAME package.examples COMMAND Python3::Interpreter
    ${PROJECT_SOURCE_DIR}/tests/package/package_test.py ${CMAKE_COMMAND} ${PROJECT_BINARY_DIR}
    ${CMAKE_CXX_COMPILER} ${consumer_flags})
  set_tests_properties(package.examples PROPERTIES LABELS package TIMEOUT 900)
endif()
