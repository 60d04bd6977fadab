#pragma once
/// gnuplot as a child process.

#include <string>
#include <string_view>

namespace dashpad::output {

/// What gnuplot writes to its standard output when it runs `script`. It reads no file of settings and none of
/// its environment variables; no shell is involved. Throws std::runtime_error with gnuplot's own words if it
/// fails, and with the name of its package if there is no `program`.
std::string gnuplot_output(const std::string& program, std::string_view script);

}  // namespace dashpad::output
