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
/// - "solve": "case" has those tables. With "standard" the case is assessed, and "mass", "radius" and "speed"
///   (SI) replace values of the standard. "quick" solves to 1e-3 at best and gives no "result", "intervals"
///   adds what is uncertain of foam and model, "whole" the whole page in place of its lead, "units" names a
///   unit system. Answer:
///   {"result": as `dashpad run` or `dashpad assess` writes it with --json, "html": the page, "title",
///   "tone", "numbers": mass, speed and thickness in SI, "toml": the case as a file}.
/// - "solve-for": the values of "key", a number of the case, at which the limits of "standard" are reached,
///   within a quarter and four times its value. Answer: {"result": as `dashpad solve-for --json`, "title"}.
/// - "fit", "pulse": tables of what was measured (src/live/measured.hpp).
/// - "list": Answer: {"foams": [{"name", "title"}], "standards": [...]}.
///
/// What cannot be answered is {"faults": [{"file", "line", "key", "value", "rule", "text"}], "lines": those
/// texts, abridged}.
std::string answer(std::string_view request, const Folders& folders);

}  // namespace dashpad::live
