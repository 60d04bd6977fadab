#pragma once
/// The engine of the live page: requests and answers are JSON, so that a worker, a program of node and a test
/// ask it in the same words.

#include <filesystem>
#include <string>
#include <string_view>

namespace dashpad::live {

/// The folders in which cards and standards are found by name.
struct Folders {
  std::filesystem::path materials, standards;
};

/// The answer to a request, an object whose "do" is one of:
///
/// - "read": "text" is a case file. Answer: {"case": its tables, as written}.
/// - "solve": "case" has those tables. With "standard" the case is assessed, and "mass", "radius", "speed",
///   "drop_height" (SI, or texts with units) replace values of the standard. "quick" solves to 1e-3 at best,
///   "intervals" adds what is uncertain of foam and model, "whole" the whole page in place of its lead,
///   "units" names a unit system. Answer:
///   {"result": as `dashpad run` or `dashpad assess` writes it with --json, "html": the page, "title",
///   "tone", "numbers": mass, speed and thickness in SI, "toml": the case as a file, "code": the exit code of
///   the command}. "others" looks at other choices of nose and speed, as `dashpad assess` does; "keep_nose"
///   and "keep_speed" are its options.
/// - "solve-for": the values of "key", a number of the case, at which the limits of "standard" are reached,
///   within a quarter and four times its value. Answer: {"result": as `dashpad solve-for --json`, "title",
///   "code"}.
/// - "check": how the case is read. Answer: {"files": [{"kind", "file"}], what it was read from, "written":
/// "text" and
///   "json" of `dashpad check`}.
/// - "materials", "standards": all, or the card "name" or the "standard", as the commands show them.
/// - "list": Answer: {"foams": [{"name", "title"}], "standards": [...]}.
///
/// In place of "case", "file" names a case file that the host has. "set" is a list of "KEY=VALUE" as of
/// --set, "tolerance" a number, and "materials" and "standards" are folders in place of those of the engine.
/// With "write", a list of "text", "all", "json", "page" and "markdown", the answer has "written", what the
/// command shows and writes, by these names, and neither result nor HTML.
///
/// What cannot be answered is {"faults": [{"file", "line", "key", "value", "rule", "text"}], "lines": those
/// texts as the command shows them}.
std::string answer(std::string_view request, const Folders& folders);

}  // namespace dashpad::live
