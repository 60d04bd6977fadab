# The style and the script of the pages of --report, which lie in web/, become a source of the library: `page_source`.

set(page_source "${PROJECT_BINARY_DIR}/page/page_source.cpp")
file(GLOB page_parts CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/web/*.*" "${PROJECT_SOURCE_DIR}/web/live/*"
     "${PROJECT_SOURCE_DIR}/web/engine/*.mjs")
add_custom_command(
  OUTPUT "${page_source}"
  COMMAND "${CMAKE_COMMAND}" -D "WEB=${PROJECT_SOURCE_DIR}/web" -D "OUTPUT=${page_source}"
          -P "${PROJECT_SOURCE_DIR}/cmake/embed_page.cmake"
  DEPENDS "${PROJECT_SOURCE_DIR}/cmake/embed_page.cmake" ${page_parts}
  COMMENT "Making the page"
  VERBATIM)
