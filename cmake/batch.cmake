# cmake -DBATCH=FILE -DSOURCES=... -P batch.cmake: a source made of others (caustics_batch_apart).
set(includes "")
set(bodies "")
foreach(source IN LISTS SOURCES)
  file(STRINGS ${source} lines REGEX "^#include [<\"]")
  list(APPEND includes ${lines})
  string(MAKE_C_IDENTIFIER ${source} name)
  string(APPEND bodies "namespace ${name} {\n#include \"${source}\"\n}\n")
endforeach()
list(REMOVE_DUPLICATES includes)
list(JOIN includes "\n" includes)
file(CONFIGURE OUTPUT ${BATCH} CONTENT "${includes}\n${bodies}" @ONLY)  # leaves an equal file alone
