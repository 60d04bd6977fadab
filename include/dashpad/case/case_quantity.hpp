#pragma once
/// The numbers of an impact case by name: to be read and set, which is what studies vary, and as a list.

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
  std::string key;   ///< as in case files: "impactor.speed", "pad.parameters.friction", "pad.curve.modulus"
  std::string unit;  ///< SI; "1" for a pure number
  /// NaN where the case does not give it, as a density that is the card's.
  std::function<double(const ImpactCase&)> get;
  /// Takes any value, which violations(ImpactCase) then judges, under the same key. Only a support that
  /// cannot exist is refused at once, with std::invalid_argument.
  std::function<void(ImpactCase&, double)> set;
};

/// Another way to say a number of a case: the one takes the place of the other.
struct OtherWay {
  const char* key;           ///< "impactor.drop_height"
  const char* unit;          ///< SI
  const char* instead_of;    ///< "impactor.speed"
  const char* meaning;       ///< "drop height"
  const char* what_follows;  ///< "the speed of the fall", of which rules are
  double (*get)(const ImpactCase&);
  void (*set)(ImpactCase&, double);
  const char* since = "0.1.0";  ///< first version of the program that has it
};

/// The weight, which is the mass times standard gravity, and the drop height h of a fall, whose speed is
/// sqrt(2 g h) with the gravity of the case; with standard gravity where the case has none.
std::span<const OtherWay> other_ways();

/// The numbers of a case in the order of case files, and each by its key.
class CaseQuantities {
 public:
  explicit CaseQuantities(std::vector<CaseQuantity> all);

  /// Null for a key that is none of them.
  [[nodiscard]] const CaseQuantity* find(const std::string& key) const;
  [[nodiscard]] auto begin() const { return all_.begin(); }
  [[nodiscard]] auto end() const { return all_.end(); }
  [[nodiscard]] std::size_t size() const { return all_.size(); }

 private:
  std::vector<CaseQuantity> all_;
  std::unordered_map<std::string, std::size_t> places_;
};

/// All that a case with this nose, this law with these forms of its curves, and this support has. They serve
/// every such case; another law throws std::bad_variant_access. `support.scale` counts from the support of
/// `base`.
CaseQuantities quantities_of(const ImpactCase& base);

/// The numbers that a case may give beside those of its law, its nose and the curve of its support: read from
/// the tables that stand with the structures, for documents, schemas and whoever asks for a list.
struct CaseField {
  std::string table;  ///< "pad", "pad.layers"
  std::string key;    ///< in that table: "area"
  std::string unit;   ///< SI; "1" for a pure number
  std::string rule;   ///< "must be at least 0 m"
  LeftOut left_out = LeftOut::refused;
  double default_value = 0;  ///< SI, of LeftOut::as_default; NaN for one that is absent then
  std::string meaning;
  std::string since;  ///< first version of the program that has it
};

/// In the order of case files.
std::vector<CaseField> case_fields();

}  // namespace dashpad
