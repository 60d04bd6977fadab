# Headers as Doxygen reads them; lines keep their numbers.
# The comment below the guard is that of the file.
1s|^#pragma once$|/// @file|
2s|^#define DASHPAD_[A-Z0-9_]+_HPP$|/// @file|
# Indented lines are formulas, and stay as they are.
s|^( *///)   ( *[^ ])|\1     \2|
/\/\/\/ {5}/b
# A sentence does not end at an abbreviation.
s/(Eqs?|Figs?|vs|cf|Vol|No)\. /\1.\\ /g
/\/\/\//s|(docs/)?theory\.md|<a href="../theory.html">theory.md</a>|g
