// A proposed fit as a fit file.

#include <fmt/format.h>

#include "dashpad/output/card_toml.hpp"
#include "dashpad/output/proposal.hpp"
#include "output/layout.hpp"
#include "output/text/case_toml.hpp"
#include "quantities/text.hpp"

namespace dashpad::output {

namespace {

std::string unknown_toml(const fit::Unknown& unknown) {
  const auto value = [&](double number) { return toml_value(number, unknown.unit); };
  return fmt::format("{} = {{bounds = [{}, {}], start = {}}}\n", toml_string(unknown.key),
                     value(unknown.lowest), value(unknown.highest), value(unknown.start));
}

std::string test_toml(const fit::TestSource& source, bool is_base, const std::filesystem::path& folder) {
  std::error_code failed;
  std::filesystem::path file = source.file;
  if (file.is_relative())
    if (auto from_there = std::filesystem::proximate(file, folder.empty() ? "." : folder, failed); !failed)
      file = std::move(from_there);
  std::string text = "\n[[tests]]\n" + toml_line("file", file.generic_string());
  const input::StressStrainColumns& columns = source.columns;
  std::string names;
  for (const auto& [key, name] :
       {std::pair{"strain", columns.strain}, {"stress", columns.stress}, {"time", columns.time}})
    if (!name.empty()) names += fmt::format("{}{} = {}", names.empty() ? "" : ", ", key, toml_string(name));
  if (!names.empty()) text += "columns = {" + names + "}\n";
  for (const auto& [key, unit] : {std::pair{"strain_unit", columns.strain_unit},
                                  {"stress_unit", columns.stress_unit},
                                  {"time_unit", columns.time_unit}})
    if (!unit.empty()) text += toml_line(key, unit);
  if (columns.thickness) text += toml_line("thickness", *columns.thickness, "m");
  if (columns.area) text += toml_line("area", *columns.area, "m2");
  if (source.rate) text += toml_line("rate", *source.rate, "1/s");
  return text + (is_base ? "is_base = true\n" : "");
}

/// Without the recoil that nobody stated: it would count as known.
std::string law_toml_of(const fit::Fit& fit) {
  std::string text = law_toml(fit.base.pad.material, "pad.");
  const std::size_t begin = text.find("recoil = ");
  if (begin != std::string::npos) text.erase(begin, text.find('\n', begin) + 1 - begin);
  return text;
}

}  // namespace

std::string proposal_toml(const fit::AutoFit& result, const std::filesystem::path& folder) {
  const fit::Fit& fit = result.candidate().fit;
  std::string text;
  for (const std::string& reason : result.proposal.reasons) text += "# " + one_line(reason) + "\n";
  text += "\n" + toml_line("title", fit.title) + "\n[pad]\n" + law_toml_of(fit) + "\n[unknowns]\n";
  for (const fit::Unknown& unknown : fit.unknowns)
    if (!unknown.is_added) text += unknown_toml(unknown);
  for (std::size_t i = 0; i < fit.tests.size(); ++i)
    text += test_toml(result.proposal.sources[i], fit.tests[i].is_base, folder);
  return text + fmt::format("\n[fit]\nstarts = {}\nseed = {}\n", fit.starts, fit.seed);
}

}  // namespace dashpad::output
