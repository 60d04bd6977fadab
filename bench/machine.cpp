#include "machine.hpp"

#include <fmt/format.h>

#include <array>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <thread>

#include "dashpad/version.hpp"

namespace dashpad::bench {
namespace {

/// The value of the first line of /proc/cpuinfo that begins with the key; "unknown" elsewhere than on Linux.
std::string cpu_info(const std::string& key) {
  std::ifstream stream("/proc/cpuinfo");
  for (std::string line; std::getline(stream, line);)
    if (line.starts_with(key)) {
      const auto colon = line.find(": ");
      if (colon != std::string::npos) return line.substr(colon + 2);
    }
  return "unknown";
}

/// Of the last minute: how busy the machine was.
std::string load() {
  std::array<double, 1> average{};
  return getloadavg(average.data(), 1) == 1 ? fmt::format("{:.2f}", average[0]) : "unknown";
}

std::string now() {
  const std::time_t seconds = std::time(nullptr);
  std::tm utc{};
  gmtime_r(&seconds, &utc);
  std::array<char, 32> text{};
  return {text.data(), std::strftime(text.data(), text.size(), "%Y-%m-%d %H:%M UTC", &utc)};
}

}  // namespace

std::vector<std::pair<std::string, std::string>> machine_facts() {
  const BuildFacts& build = build_facts();
  return {
      {"measured", now()},
      {"cpu", fmt::format("{} (family {}, model {}), {} cores", cpu_info("model name"),
                          cpu_info("cpu family"), cpu_info("model\t"), std::thread::hardware_concurrency())},
      {"load", load()},
      {"commit", std::string(build.git_commit)},
      {"compiler", std::string(build.compiler)},
      {"flags", std::string(build.compiler_flags)},
      {"build type", std::string(build.build_type)}};
}

double thread_time() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

}  // namespace dashpad::bench
