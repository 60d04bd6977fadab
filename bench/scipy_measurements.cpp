// The SciPy script: a process of its own for each setting, which times itself.

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>
#include <type_traits>
#include <variant>

#include "contenders.hpp"

namespace dashpad::bench {
namespace {

namespace fs = std::filesystem;

constexpr const char* python = "OMP_NUM_THREADS=1 OPENBLAS_NUM_THREADS=1 /usr/bin/python3";

struct Setting {
  int columns;
  double rtol;
};

/// What a command prints; empty if it fails.
std::string output_of(const std::string& command) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> pipe(popen(command.c_str(), "r"), pclose);
  if (!pipe) throw std::runtime_error("cannot run " + command);
  std::string text;
  std::array<char, 4096> part{};
  for (std::size_t size = 0; (size = std::fread(part.data(), 1, part.size(), pipe.get())) > 0;)
    text.append(part.data(), size);
  return text;
}

void write_case(const ImpactCase& impact, const fs::path& file) {
  nlohmann::json parameters;
  std::visit(
      [&](const auto& law) {
        for (const auto& parameter : std::decay_t<decltype(law)>::parameters)
          parameters[parameter.key] = parameter.of(law);
      },
      impact.pad.material.law);
  const Support::Point& point = impact.support.points().at(0);
  std::ofstream stream(file);
  stream << nlohmann::json{{"law", name_of(impact.pad.material.law)},
                           {"parameters", parameters},
                           {"mass", impact.impactor.mass},
                           {"radius", sphere_radius(impact.impactor.nose)},
                           {"speed", impact.impactor.speed},
                           {"thickness", impact.pad.thickness},
                           {"stiffness", point.force / point.deflection}};
  if (!stream) throw std::runtime_error("cannot write " + file.string());
}

/// The share of the speed, the figures and the time of each line.
std::vector<std::array<double, 5>> solutions_of(const std::string& text) {
  std::vector<std::array<double, 5>> solutions;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream cells(line);
    std::vector<double> row;
    for (std::string cell; std::getline(cells, cell, ',');) row.push_back(std::stod(cell));
    solutions.push_back({row.at(2), row.at(3), row.at(4), row.at(5), row.at(6)});
  }
  return solutions;
}

}  // namespace

std::vector<Measurement> scipy_measurements(const ImpactCase& impact, const References& references,
                                            bool quick) {
  if (output_of(std::string(python) + " -c 'import scipy; print(scipy.__version__)' 2>&1").find("Error") !=
      std::string::npos) {
    fmt::print(stderr, "No SciPy (python3-scipy): it does not compete\n");
    return {};
  }
  std::vector<Setting> settings{{20, 1e-2}, {20, 1e-3}, {40, 1e-3}, {40, 1e-4}, {80, 1e-5}};
  if (quick) settings.resize(2);
  const fs::path file = fs::temp_directory_path() / fmt::format("dashpad-scipy-{}.json", impact.title);
  write_case(impact, file);
  std::vector<Measurement> measurements;
  for (const Setting& setting : settings) {
    Measurement m;
    m.solver = "SciPy script";
    m.setting = fmt::format("{} columns rtol {:.0e}", setting.columns, setting.rtol);
    for (const auto& [share, force, penetration, speed, time] : solutions_of(output_of(
             fmt::format("{} '{}/bench/scipy_impact.py' --case '{}' --columns {} --rtol {} --repeat 3 "
                         "--shares 0.96 0.98 1.02 1.04 2>/dev/null",
                         python, DASHPAD_SOURCE_DIR, file.string(), setting.columns, setting.rtol)))) {
      if (std::isnan(force)) {
        ++m.failures;
        continue;
      }
      m.errors = worse(m.errors, deviation({force, penetration, speed}, references.at(share).released));
      if (share == 1) m.times.push_back(time);
    }
    if (!m.times.empty()) measurements.push_back(std::move(m));
  }
  fs::remove(file);
  return measurements;
}

}  // namespace dashpad::bench
