# Makes a C++ source of the styles and scripts of pages:
#   cmake -D WEB=FOLDER -D OUTPUT=FILE -P embed_page.cmake

# What every page runs, in the order in which the files need each other, and what the live page runs behind it.
set(of_all scale curves panel plot units moment drawing main)
set(of_live unpack engine state sliders files pads live)

# join(VARIABLE FOLDER name...): the files, without indentation and comments on lines of their own.
function(join variable folder)
  foreach(name IN LISTS ARGN)
    file(READ "${WEB}/${folder}${name}" text)
    string(APPEND all "\n${text}")
  endforeach()
  string(REGEX REPLACE "\n *//[^\n]*" "" all "${all}")
  string(REGEX REPLACE "\n[\n ]+" "\n" all "${all}")
  set(${variable} "${all}" PARENT_SCOPE)
endfunction()

list(TRANSFORM of_all APPEND .js)
list(TRANSFORM of_live APPEND .js)
join(parts "" ${of_all})
join(live_parts "live/" ${of_live})
join(engine "engine/" engine.mjs)
string(REPLACE "export function" "function" engine "${engine}")
join(style "" page.css)
join(live_style "live/" live.css)
join(live_controls "live/" controls.html)
set(script "(() => {\n\"use strict\";${parts}\nenliven();\n})();\n")
set(live_script "(() => {\n\"use strict\";${parts}${engine}${live_parts}\n})();\n")

file(GLOB scripts RELATIVE "${WEB}" "${WEB}/*.js" "${WEB}/live/*.js")
list(LENGTH scripts all)
list(LENGTH of_all joined)
list(LENGTH of_live joined_live)
math(EXPR joined "${joined} + ${joined_live}")
if(NOT all EQUAL joined)
  message(FATAL_ERROR "web/ has ${all} scripts, of which ${joined} are joined")
endif()

set(source "// Made by cmake/embed_page.cmake.
#include \"output/page/html.hpp\"

// Compilers need not read longer literals, but all of ours do.
#pragma GCC diagnostic ignored \"-Woverlength-strings\"

namespace dashpad::output {

")
foreach(text IN ITEMS script style live_script live_style live_controls)
  string(TOLOWER "${${text}}" small)
  if(small MATCHES "</(script|style)|<!--|[)]page\"")
    message(FATAL_ERROR "the ${text} of the page would end its own element or literal: ${CMAKE_MATCH_0}")
  endif()
  string(APPEND source "const std::string_view page_${text} = R\"page(${${text}})page\";\n")
endforeach()
file(WRITE "${OUTPUT}" "${source}
}  // namespace dashpad::output
")
