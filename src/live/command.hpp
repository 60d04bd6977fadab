#pragma once
/// The engine of the command that node runs: answers as the native command shows and writes them.

#include <string>
#include <string_view>

#include "live/answer.hpp"

namespace dashpad::live {

/// The answer to a request, an object whose "do" is one of:
///
/// - "solve": solves "case", the tables of a case as JSON, or "file", a case file that the host has. With
///   "standard" the case is assessed, and "mass", "radius", "speed" and "drop_height" (SI, or texts with
///   units) replace values of the standard; "keep_nose" and "keep_speed" are options of `dashpad assess`, and
///   "others" looks at other choices of them, as it does. "intervals" adds what is uncertain of foam and
///   model.
/// - "solve-for": the values of "key", a number of the case, at which the limits of "standard" and "until", a
///   list of limits as of --until, are reached.
/// - "check": how the case is read; answers with "files", too, from which: [{"kind", "file"}].
/// - "materials", "standards": all, or the card "name" or the "standard".
/// - "list": as for a live page.
/// - "spell": answers with "text", which of "words" an unknown "word" may mean, or else all of them:
///   `; did you mean "run"?`.
///
/// "write" lists "text" and "all" of the terminal, "json", "page" and "markdown"; the answer has "written",
/// these texts by their names, and "code", the exit code of the command. "set" is a list of "KEY=VALUE" as of
/// --set, "tolerance" a number or its text, "units" a unit system; "materials" and "standards" are folders in
/// place of those of the engine. What cannot be answered is {"faults": [{"file", "line", "key", "value",
/// "rule", "text"}], "lines": those texts as the command shows them}.
std::string command_answer(std::string_view request, const Folders& folders);

}  // namespace dashpad::live
