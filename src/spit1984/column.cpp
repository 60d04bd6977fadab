#include "dashpad/spit1984/run.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "dashpad/quantities/quantity.hpp"
#include "spit1984/pad.hpp"

namespace dashpad::spit1984 {
namespace {

void check(PadKey pad, const std::array<double, 21>& parameters, const std::vector<double>& strains,
           double step) {
  Deck deck{.radius_in = 1,
            .speed_mph = 1,
            .weight_lb = 1,
            .pad = pad,
            .pad_parameters = parameters,
            .thickness_in = 1};
  deck.support_parameters[8] = 1;
  std::string text;
  const auto add = [&text](const std::string& name, double value, const std::string& rule) {
    text += fmt::format("{}{} is {}: {}", text.empty() ? "" : "; ", name, value, rule);
  };
  for (const Violation& v : violations(deck)) add(v.key, v.value, v.rule);
  if (!(step > 0 && std::isfinite(step))) add("step", step, "must be more than 0 (s)");
  if (strains.size() < 2) add("number of strains", double(strains.size()), "must be at least 2");
  if (!strains.empty() && strains.front() != 0)
    add("strains[0]", strains.front(), "must be 0, because a history starts at first contact");
  for (std::size_t i = 0; i < strains.size(); ++i)
    if (!(strains[i] >= 0 && strains[i] < 1))
      add(fmt::format("strains[{}]", i), strains[i], "must be at least 0 and less than 1");
  if (!text.empty()) throw std::invalid_argument(text);
}

/// The first station is the axis. The second is the contact edge, whose stress laws 4 and 5 set to 0.
template <class Real>
std::vector<double> stresses(PadKey pad, const std::array<double, 21>& parameters,
                             const std::vector<double>& strains, double step) {
  constexpr int stations = 2;
  const PadParameters<Real> in_its_numbers = converted<Real>(parameters);
  const auto time_step = static_cast<Real>(step);
  ContactField<Real> field(stations);
  Real time(0);
  std::vector<double> result{0};
  for (std::size_t k = 1; k < strains.size(); ++k) {
    time = time + time_step;
    field.new_strain[0] = static_cast<Real>(-strains[k]);
    update_stresses(pad, in_its_numbers, field, stations, time_step, time);
    field.accept(0);
    result.push_back(0 - to_double(field.stress[0]));
  }
  return result;
}

}  // namespace

std::vector<double> column_stresses(PadKey pad, const std::array<double, 21>& parameters,
                                    const std::vector<double>& strains, double step, Arithmetic arithmetic) {
  check(pad, parameters, strains, step);
  switch (arithmetic) {
    case Arithmetic::binary32: return stresses<float>(pad, parameters, strains, step);
    case Arithmetic::binary64: return stresses<double>(pad, parameters, strains, step);
    case Arithmetic::pdp10: break;
  }
  return stresses<Pdp10>(pad, parameters, strains, step);
}

std::vector<double> stresses_of_update(const Material& material, const std::vector<double>& strains,
                                       double step) {
  ImpactCase impact;
  impact.pad.material = material;
  const Deck deck = deck_of(impact);
  const double psi = to_si("1 psi", "Pa");
  std::vector<double> result = column_stresses(deck.pad, deck.pad_parameters, strains, step);
  for (double& stress : result) stress *= psi;
  return result;
}

}  // namespace dashpad::spit1984
