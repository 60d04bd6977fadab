# The page of `dashpad run --report` and the page of figures: npm fetches uPlot and esbuild into the build folder,
# web/build.mjs makes one HTML file of web/page and one of web/figures, and these become a source of the library.
# Sets `page_source`.

set(page_folder "${PROJECT_BINARY_DIR}/page")
set(page_source "${page_folder}/page_template.cpp")

if(NOT DASHPAD_BUILD_PAGE)
  set(page_source "${page_folder}/no_page_template.cpp")
  file(CONFIGURE OUTPUT "${page_source}" CONTENT [[
#include "output/page/page_template.hpp"

namespace dashpad::output {

const PageParts page_parts;
const PageParts figures_page_parts;

}  // namespace dashpad::output
]] @ONLY)
  return()
endif()

find_program(DASHPAD_NODE NAMES node nodejs)
find_program(DASHPAD_NPM npm)
mark_as_advanced(DASHPAD_NODE DASHPAD_NPM)
if(NOT DASHPAD_NODE OR NOT DASHPAD_NPM)
  message(FATAL_ERROR "The page of dashpad run --report needs Node and npm, in Debian the packages nodejs and npm. "
                      "To build without it: -DDASHPAD_BUILD_PAGE=OFF")
endif()

# npm_packages(FOLDER FROM): what FROM/package-lock.json names lies in FOLDER/node_modules once FOLDER/fetched
# exists. Packages run no scripts of theirs.
function(npm_packages folder from)
  add_custom_command(
    OUTPUT "${folder}/fetched"
    COMMAND "${CMAKE_COMMAND}" -E copy "${from}/package.json" "${from}/package-lock.json" "${folder}"
    COMMAND "${DASHPAD_NPM}" ci --include=dev --ignore-scripts --no-audit --no-fund --no-update-notifier
            --no-progress --loglevel=error
    COMMAND "${CMAKE_COMMAND}" -E touch "${folder}/fetched"
    DEPENDS "${from}/package.json" "${from}/package-lock.json"
    WORKING_DIRECTORY "${folder}"
    COMMENT "Fetching npm packages"
    VERBATIM)
  file(MAKE_DIRECTORY "${folder}")
endfunction()

npm_packages("${page_folder}" "${PROJECT_SOURCE_DIR}/web")
set(web "${PROJECT_SOURCE_DIR}/web")
file(GLOB page_parts CONFIGURE_DEPENDS "${web}/both/*" "${web}/page/*" "${web}/figures/*")
add_custom_command(
  OUTPUT "${page_source}"
  COMMAND "${DASHPAD_NODE}" "${PROJECT_SOURCE_DIR}/web/build.mjs" "${page_folder}" "${page_source}"
  DEPENDS "${page_folder}/fetched" "${PROJECT_SOURCE_DIR}/web/build.mjs" ${page_parts}
  COMMENT "Making the pages"
  VERBATIM)
