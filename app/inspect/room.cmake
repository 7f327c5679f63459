# The page's texts as part of the program: the scripts one after the other, as modules.txt lists them.
set(page ${PROJECT_SOURCE_DIR}/app/inspect/page)
file(STRINGS ${page}/modules.txt modules)
set(PAGE_SCRIPT "")
foreach(module IN LISTS modules)
  file(READ ${page}/${module} text)
  string(APPEND PAGE_SCRIPT "${text}\n")
  set_property(DIRECTORY ${PROJECT_SOURCE_DIR} APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${page}/${module})
endforeach()
file(READ ${page}/page.html PAGE_FRAME)
file(READ ${page}/page.css PAGE_STYLE)
set_property(DIRECTORY ${PROJECT_SOURCE_DIR} APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${page}/modules.txt
  ${page}/page.html ${page}/page.css)
configure_file(${PROJECT_SOURCE_DIR}/app/inspect/page_text.cpp.in ${PROJECT_BINARY_DIR}/app/page_text.cpp
  @ONLY)
target_sources(caustics_app PRIVATE ${PROJECT_BINARY_DIR}/app/page_text.cpp)
