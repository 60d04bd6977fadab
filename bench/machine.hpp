#pragma once
/// What a measurement is worth nothing without: the machine, the compiler, the commit. No names of hosts or
/// users.

#include <string>
#include <utility>
#include <vector>

namespace dashpad::bench {

/// Key and value, such as {"cpu", "AMD EPYC, 2 cores"}.
std::vector<std::pair<std::string, std::string>> machine_facts();

/// CPU time that this thread has used, s: what other programs on the same core take does not count.
double thread_time();

}  // namespace dashpad::bench
