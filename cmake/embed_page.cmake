# Makes a C++ source of the page's style and script:
#   cmake -D WEB=FOLDER -D OUTPUT=FILE -P embed_page.cmake

set(script "(() => {\n\"use strict\";\n")
# In the order in which they need each other.
set(names scale curves panel plot units moment drawing main)
foreach(name IN LISTS names)
  file(READ "${WEB}/${name}.js" text)
  string(APPEND script "\n${text}")
endforeach()
string(APPEND script "})();\n")
file(GLOB scripts "${WEB}/*.js")
list(LENGTH scripts all)
list(LENGTH names joined)
if(NOT all EQUAL joined)
  message(FATAL_ERROR "web/ has ${all} scripts, of which ${joined} are joined")
endif()
file(READ "${WEB}/page.css" style)
# Comments on lines of their own, and indentation, are a third of it.
string(REGEX REPLACE "\n *//[^\n]*" "" script "${script}")
string(REGEX REPLACE "\n[\n ]+" "\n" script "${script}")
string(REGEX REPLACE "\n[\n ]+" "\n" style "${style}")

foreach(text IN ITEMS script style)
  string(TOLOWER "${${text}}" small)
  if(small MATCHES "</(script|style)|<!--|[)]page\"")
    message(FATAL_ERROR "the ${text} of the page would end its own element or literal: ${CMAKE_MATCH_0}")
  endif()
endforeach()

file(WRITE "${OUTPUT}" "// Made by cmake/embed_page.cmake.
#include \"output/page/html.hpp\"

namespace dashpad::output {

const std::string_view page_style = R\"page(${style})page\";
const std::string_view page_script = R\"page(${script})page\";

}  // namespace dashpad::output
")
