#pragma once
/// The numbers of an impact case by their dotted keys: read and set by studies and fits, and listed.

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

#include "dashpad/impact/impact_case.hpp"
#include "dashpad/model/parameter.hpp"

namespace dashpad {

/// A number of a case, in SI.
struct CaseQuantity {
  std::string key;   ///< key in case files: "impactor.speed", "pad.parameters.friction", "pad.curve.modulus"
  std::string unit;  ///< SI; "1" for a pure number
  /// The value, of a density that of the card if the case gives none; NaN for a temperature left to the card.
  std::function<double(const ImpactCase&)> get;
  /// Sets any value; violations(ImpactCase) checks it later, under the same key. Only for a support that
  /// cannot exist it throws, std::invalid_argument.
  std::function<void(ImpactCase&, double)> set;
};

/// An alternative to a number of a case, which it replaces.
struct OtherWay {
  const char* key;           ///< "impactor.drop_height"
  const char* unit;          ///< SI
  Bounds bounds = {};        ///< of the value itself; the number that follows has its own
  const char* instead_of;    ///< "impactor.speed"
  const char* meaning;       ///< "drop height"
  const char* what_follows;  ///< "the speed after the fall": subject of broken rules
  double (*get)(const ImpactCase&);
  void (*set)(ImpactCase&, double);
  const char* rule_if_missing = "is missing";  ///< for a case that states the number in neither way
  const char* since = "0.1.0";                 ///< first version of the program that has it
};

/// The weight, M times standard gravity, and the drop height h, with the speed sqrt(2 g h); g is the gravity
/// of the case, or standard gravity if the case has none.
std::span<const OtherWay> other_ways();

/// The key of the static stress of a flat nose on the area that it loads, which studies and fits may vary in
/// place of the mass. It depends on that area, so it is set after all other numbers.
inline constexpr const char* static_stress = "impactor.static_stress";

/// The number of a case that a key decides: impactor.speed for a drop height, impactor.mass for a weight or a
/// static stress, itself for every other key.
std::string decided_by(const std::string& key);

/// The numbers of a case, in the order of case files and by key.
class CaseQuantities {
 public:
  explicit CaseQuantities(std::vector<CaseQuantity> all);

  /// Null for an unknown key.
  [[nodiscard]] const CaseQuantity* find(const std::string& key) const;
  [[nodiscard]] auto begin() const { return all_.begin(); }
  [[nodiscard]] auto end() const { return all_.end(); }
  [[nodiscard]] std::size_t size() const { return all_.size(); }

 private:
  std::vector<CaseQuantity> all_;
  std::unordered_map<std::string, std::size_t> places_;
};

/// All numbers of a case with the nose, law, forms of curves and support of `base`. On a case with another
/// law or nose they throw std::bad_variant_access. `support.scale` is relative to that of `base`.
CaseQuantities quantities_of(const ImpactCase& base);

/// The number of a case by its key; NaN if the case has none.
double case_value(const ImpactCase& impact, const std::string& key);

/// A number of a case beside those of law, nose and curve of the support, from the parameter tables.
struct CaseField {
  std::string table;  ///< "pad", "pad.layers"
  std::string key;    ///< key in that table: "area"
  std::string unit;   ///< SI; "1" for a pure number
  std::string rule;   ///< "must be at least 0 m"
  LeftOut left_out = LeftOut::refused;
  double default_value = 0;  ///< SI, for LeftOut::as_default; NaN if absent by default
  std::string meaning;
  std::string since;  ///< first version of the program that has it
};

/// All such numbers, in the order of case files.
std::vector<CaseField> case_fields();

}  // namespace dashpad
