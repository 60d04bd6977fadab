// Foams of Abaqus input files: *LOW DENSITY FOAM with its tests, *HYPERFOAM with tests or coefficients.
//
// *UNIAXIAL TEST DATA has rows of nominal stress, nominal strain, [lateral strain,] and, for a low-density
// foam, the rate. A low-density foam states absolute values, and unloading at negative rates; of a hyperfoam
// compression is negative. *HYPERFOAM, N=2 has mu_1, alpha_1, mu_2, alpha_2, nu_1, nu_2.

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>

#include <fmt/format.h>

#include "input/material_deck/abaqus.hpp"
#include "quantities/text.hpp"

namespace dashpad::input {

namespace {

constexpr double assumed_strain_of_fit = 0.8;  // of coefficients, whose range is not stated
constexpr std::size_t max_rows_of_abaqus = 100'000;
constexpr const char* no_loss =
    "There is no unloading curve, so the foam unloads along the curve for the lowest rate, without loss at "
    "that rate.";

/// Keywords of materials that are not read.
constexpr std::array other_materials{"ELASTIC",
                                     "PLASTIC",
                                     "HYPERELASTIC",
                                     "ANISOTROPIC HYPERELASTIC",
                                     "HYPOELASTIC",
                                     "CRUSHABLE FOAM",
                                     "DRUCKER PRAGER",
                                     "MOHR COULOMB",
                                     "CAP PLASTICITY",
                                     "POROUS ELASTIC",
                                     "CONCRETE",
                                     "FABRIC",
                                     "CAST IRON PLASTICITY",
                                     "USER MATERIAL",
                                     "GASKET BEHAVIOR",
                                     "HONEYCOMB",
                                     "DEFORMATION PLASTICITY"};

/// Reads the foams keyword by keyword.
class AbaqusReader {
 public:
  AbaqusReader(const DeckUnits& units, const DeckParameters& parameters, MeasurementFaults& faults)
      : units_(units), parameters_(parameters), faults_(faults) {}

  void keyword(AbaqusKeyword keyword) {
    const std::string& name = keyword.name;
    is_read_ = false;
    if (name == "MATERIAL") {
      finish();
      title_ = to_utf8(unquoted(keyword.parameters["NAME"]));
      density_ = 0;
    } else if (name == "LOW DENSITY FOAM" || name == "HYPERFOAM") {
      begin(keyword);
    } else if (name == "UNIAXIAL TEST DATA" && foam_) {
      const auto direction = keyword.parameters.find("DIRECTION");
      is_read_ = direction == keyword.parameters.end() || upper_case(direction->second) != "TENSION";
    } else if (foam_ && (name == "MULLINS EFFECT" || name == "VISCOELASTIC" || name == "HYSTERESIS")) {
      foam_->differences.push_back(fmt::format(
          "*{} and its energy loss are left out; set unloading_factor and unloading_shape.", name));
    } else if (name.ends_with(" TEST DATA") && foam_) {
      foam_->differences.push_back(
          fmt::format("*{} is left out: a pad is compressed in one direction only.", name));
    } else {
      is_read_ = name == "DENSITY";
    }
    keyword_ = std::move(keyword);
  }

  void row(const DeckLine& line) {
    if (!is_read_) return;
    if (++rows_ > max_rows_of_abaqus)
      faults_.refuse(line.number, "", "", fmt::format("has more than {} rows", max_rows_of_abaqus));
    DeckFields fields(line, Widths(max_fields, 20), true, faults_);
    if (keyword_.name == "DENSITY") {
      density_ = fields.number(0, "*DENSITY", units_.density);
    } else if (keyword_.name == "HYPERFOAM") {
      for (std::size_t i = 0; i < max_fields; ++i) coefficients_.push_back(fields.number(i, "*HYPERFOAM"));
      coefficient_line_ = line.number;
    } else {
      point(fields);
    }
  }

  std::vector<DeckFoam> foams() {
    finish();
    return std::move(foams_);
  }

 private:
  static constexpr std::size_t max_fields = 8;

  void begin(const AbaqusKeyword& keyword) {
    if (foams_.size() == max_foams_of_deck)
      faults_.refuse(keyword.line, "", "", fmt::format("has more than {} foams", max_foams_of_deck));
    foam_.emplace();
    foam_->card = "*" + keyword.name;
    foam_->line = keyword.line;
    foam_->id = static_cast<long>(foams_.size()) + 1;
    is_hyperfoam_ = keyword.name == "HYPERFOAM";
    is_read_ = is_hyperfoam_ && !keyword.parameters.contains("TEST DATA INPUT");
    has_fault_ = false;
    terms_ = terms_of(keyword);
    const auto lateral = keyword.parameters.find("LATERAL STRAIN DATA");
    has_lateral_ = lateral != keyword.parameters.end() && upper_case(lateral->second) != "NO";
    coefficients_.clear();
    curves_.clear();
  }

  /// The number N of terms, at most 9; 0 if it is none.
  std::size_t terms_of(const AbaqusKeyword& keyword) {
    const auto n = keyword.parameters.find("N");
    if (n == keyword.parameters.end()) return 1;
    const auto use = parameter_use(n->second, parameters_);
    if (use && !use->rule.empty())
      faults_.add(keyword.line, foam_->card + ": N", to_utf8(n->second), use->rule);
    const double terms = use ? use->value : read_number(n->second).value;
    has_fault_ = use && (!use->rule.empty() || std::isnan(terms));
    return terms > 0 ? static_cast<std::size_t>(std::min(terms, 9.0)) : 0;
  }

  void point(DeckFields& fields) {
    const std::string key = foam_->card + ": test ";
    double stress = fields.number(0, key + "stress", units_.stress),
           strain = fields.number(1, key + "strain");
    double rate = 0;
    if (is_hyperfoam_) {  // compression is negative; what is pulled is not for a pad
      stress = -stress;
      strain = -strain;
      if (strain < 0) return;
    } else {
      rate = fields.number(has_lateral_ ? 3 : 2, key + "rate", units_.rate);
    }
    has_fault_ = has_fault_ || std::isnan(rate);
    if (std::isnan(rate)) return;
    const auto [place, is_new] = curves_.try_emplace(rate);
    if (is_new)
      place->second = {is_hyperfoam_ ? "test of the *HYPERFOAM" : fmt::format("test at {:g} 1/s", rate),
                       fields.line()};
    place->second.add(strain == 0 ? 0 : strain, stress == 0 ? 0 : stress, fields.line());
  }

  /// Sets the base curve from coefficients; false after a fault.
  bool take_coefficients() {
    const std::size_t needed = 3 * terms_;
    if (terms_ < 1 || terms_ > 2) {
      faults_.add(foam_->line, foam_->card + ": N", fmt::format("{}", terms_),
                  "must be 1 or 2; a hyperfoam curve in Dashpad has at most two terms");
      return false;
    }
    if (coefficients_.size() < needed) {
      faults_.add(foam_->line, foam_->card, "", fmt::format("needs {} coefficients", needed));
      return false;
    }
    const auto modulus = [&](std::size_t i) { return coefficients_[i] * units_.stress.factor; };
    foam_->hyperfoam = HyperfoamCurve{modulus(0), coefficients_[1], terms_ == 2 ? modulus(2) : 0,
                                      terms_ == 2 ? coefficients_[3] : 0, assumed_strain_of_fit};
    foam_->assumptions.push_back(
        fmt::format("The strain up to which the coefficients were fitted is not stated; {:g} was used.",
                    assumed_strain_of_fit));
    if (std::any_of(coefficients_.begin() + static_cast<std::ptrdiff_t>(2 * terms_),
                    coefficients_.begin() + static_cast<std::ptrdiff_t>(needed),
                    [](double nu) { return nu != 0; }))
      foam_->differences.emplace_back("nu is not 0, but the pad does not expand laterally; 0 is used.");
    foam_->assumptions.emplace_back(no_loss);
    foam_->loading.push_back({0, foam_->line, {"coefficients", coefficient_line_}});
    return true;
  }

  void finish() {
    if (!foam_) return;
    foam_->title = title_;
    foam_->density = density_;
    const bool is_sound = !has_fault_ && (coefficients_.empty() ? take_tests() : take_coefficients());
    if (is_sound) foams_.push_back(*std::move(foam_));
    foam_.reset();
  }

  /// Loadings by their rates; the way back of the slowest.
  bool take_tests() {
    for (auto& [rate, curve] : curves_) {
      if (std::ranges::is_sorted(curve.strain, std::ranges::greater())) curve.reverse();
      if (rate >= 0) foam_->loading.push_back({rate, curve.line, curve});
      if (rate < 0) foam_->unloading = curve;  // rates ascend: the slowest way back comes last
    }
    if (curves_.empty() || foam_->loading.empty()) {
      faults_.add(foam_->line, foam_->card, "", "has no *UNIAXIAL TEST DATA for loading in compression");
      return false;
    }
    if (std::ranges::count_if(curves_, [](const auto& each) { return each.first < 0; }) > 1)
      foam_->differences.emplace_back("Only the slowest unloading curve was used.");
    if (!foam_->unloading) foam_->assumptions.emplace_back(no_loss);
    return true;
  }

  const DeckUnits& units_;
  const DeckParameters& parameters_;
  MeasurementFaults& faults_;
  std::vector<DeckFoam> foams_;
  std::optional<DeckFoam> foam_;
  AbaqusKeyword keyword_;
  std::string title_;
  double density_ = 0;
  bool is_read_ = false, is_hyperfoam_ = false, has_lateral_ = false;
  bool has_fault_ = false;  ///< the foam, in its keyword or a rate
  std::size_t rows_ = 0, terms_ = 1, coefficient_line_ = 0;
  std::vector<double> coefficients_;
  std::map<double, DeckCurve> curves_;  ///< by rate
};

/// Whether the deck holds foams, and what else.
bool has_foams(std::string_view text, OutOfReach& other) {
  bool found = false;
  each_abaqus_line(
      text,
      [&](const AbaqusKeyword& keyword) {
        found = found || keyword.name == "LOW DENSITY FOAM" || keyword.name == "HYPERFOAM";
        if (std::ranges::find(other_materials, keyword.name) != other_materials.end())
          other.add_material("*" + keyword.name);
        if (keyword.name == "INCLUDE") other.include = "*INCLUDE";
      },
      [](const DeckLine&) {});
  return found;
}

}  // namespace

std::vector<DeckFoam> read_abaqus(const DeckText& deck, UnitChoice& units, MeasurementFaults& faults) {
  OutOfReach other;
  if (!has_foams(deck.text, other)) {
    faults.add(0, "", "", contains_no("Abaqus *LOW DENSITY FOAM or *HYPERFOAM", other));
    return {};
  }
  const auto chosen = units.for_numbers({});
  if (!chosen) return {};
  const DeckParameters parameters = abaqus_parameters(deck.text, faults);
  AbaqusReader reader(chosen->units, parameters, faults);
  each_abaqus_line(
      deck.text, [&](const AbaqusKeyword& keyword) { reader.keyword(keyword); },
      [&](const DeckLine& line) {
        reader.row({line.number, line.text, &parameters});
      });
  std::vector<DeckFoam> foams = reader.foams();
  for (DeckFoam& foam : foams) foam.units = chosen->words;
  return foams;
}

}  // namespace dashpad::input
