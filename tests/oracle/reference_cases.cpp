#include "oracle/reference_cases.hpp"

#include <fstream>
#include <sstream>
#include <stdexcept>

namespace dashpad::oracle {

namespace {

constexpr double inch = 0.0254;                      // m
constexpr double pound_force = 4.4482216152605;      // N
constexpr double psi = pound_force / (inch * inch);  // Pa
constexpr double mile_per_hour = 17.64 * inch;       // m/s, as the report rounds it

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, separator);) parts.push_back(part);
  return parts;
}

Support support_of(const std::string& text) {
  if (text == "rigid") return Support::rigid();
  if (text.starts_with("K=")) return Support::linear(std::stod(text.substr(2)) * pound_force / inch);
  std::vector<Support::Point> points;
  for (const std::string& pair : split(text, ';')) {
    const auto values = split(pair, ':');
    points.push_back({std::stod(values.at(0)) * inch, std::stod(values.at(1)) * pound_force});
  }
  return Support::through(points);
}

PadLaw law_of(const std::string& law, const std::string& parameters) {
  if (parameters == "ensolite-9") return ensolite_nine();
  if (parameters == "ensolite-21") return ensolite_twenty_one();
  const auto values = split(parameters, '|');
  if (law == "1") return Elastic{std::stod(values.at(0)) * psi};
  if (law == "3")
    return RigidFoam{std::stod(values.at(0)) * psi, std::stod(values.at(1)), std::stod(values.at(2)) * psi,
                     std::stod(values.at(3))};
  throw std::runtime_error("reference cases: unknown law " + law + " " + parameters);
}

ReferenceCase case_of(const std::vector<std::string>& fields) {
  const auto number = [&](std::size_t i) { return std::stod(fields.at(i)); };
  ReferenceCase result;
  result.id = fields.at(0);
  result.impact.title = "reference case " + result.id;
  result.impact.impactor = {number(8), Sphere{number(3) * inch}, number(9)};
  result.impact.pad.thickness = number(6) * inch;
  result.impact.pad.material.law = law_of(fields.at(1), fields.at(2));
  result.impact.support = support_of(fields.at(7));
  result.peak_force = number(10) * pound_force;
  result.time_of_peak_force = number(11) * 1e-3;
  result.peak_motion = number(12) * inch;
  result.peak_penetration = number(13) * inch;
  result.weight = {number(15) * 1e-3, -number(14) * mile_per_hour};
  result.release = {number(17) * 1e-3, -number(16) * mile_per_hour};
  result.energy_loss = number(18);
  result.contact_end = {number(20) * 1e-3, -number(19) * mile_per_hour};
  return result;
}

}  // namespace

NineParameter ensolite_nine() {
  NineParameter law;
  law.asymptotic_modulus = 7.96 * psi;
  law.contact_exponent = 0.675;
  law.compaction_exponent = 1.09;
  law.relaxation_time = 8.81e-3;
  law.rate_modulus = 5.45 * psi;
  law.rate_exponent = 0.166;
  law.residual_strain_time = 9.76e-6;
  law.residual_strain_exponent = 0.0987;
  return law;
}

TwentyOneParameter ensolite_twenty_one() {
  TwentyOneParameter law;
  law.asymptotic_modulus = 7.96 * psi;
  law.contact_exponent = 0.675;
  law.compaction_exponent = 1.09;
  law.relaxation_exponent = 0.13;
  law.relaxation_scale = 0.156;
  law.relaxation_strain_base = 3.08;
  law.rate_stress = 4.153 * psi;
  law.rate_exponent = 0.19;
  law.rate_strain_exponent = 3.17;
  law.rate_strain_scale = 0.58;
  law.growth_strain_exponent = 2.57;
  law.growth_strain_scale = 0.296;
  law.onset_strain_exponent = 2.23;
  law.onset_strain_scale = 1.64e-3;
  law.residual_strain_time = 9.76e-6;
  law.residual_strain_exponent = 0.0987;
  return law;
}

std::vector<ReferenceCase> read_reference_cases(const std::filesystem::path& file) {
  std::ifstream stream(file);
  if (!stream) throw std::runtime_error("reference cases: cannot read " + file.string());
  std::vector<ReferenceCase> cases;
  for (std::string line; std::getline(stream, line);)
    if (!line.empty() && line[0] != '#' && !line.starts_with("id,"))
      cases.push_back(case_of(split(line, ',')));
  return cases;
}

ReferenceCase reference_case(const std::filesystem::path& file, const std::string& id) {
  for (const ReferenceCase& entry : read_reference_cases(file))
    if (entry.id == id) return entry;
  throw std::runtime_error("reference cases: no case " + id + " in " + file.string());
}

}  // namespace dashpad::oracle
