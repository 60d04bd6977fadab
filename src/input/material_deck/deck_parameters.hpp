#pragma once
/// Parameters of decks, and the expressions that compute them.

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "input/measurement/measurement_text.hpp"

namespace dashpad::input {

/// How a solver defines and computes its parameters.
struct ParameterLanguage {
  const char* keyword;     ///< that defines them, for messages
  bool is_python = false;  ///< ^ is no power, and of two whole numbers / gives the floor
};
inline constexpr ParameterLanguage ls_dyna_language{"*PARAMETER"}, radioss_language{"/PARAMETER/GLOBAL"},
    abaqus_language{"*PARAMETER", true};

struct DeckParameter {
  double value = 0;  ///< NaN if its definition has a fault
  bool is_whole = false;
};

/// Parameters by their names, in which capitals do not matter, and those of an outer scope, which must
/// outlive this one and are hidden by the same names here.
class DeckParameters {
 public:
  explicit DeckParameters(const ParameterLanguage& language, const DeckParameters* outer = nullptr)
      : language_(language), outer_(outer) {}

  /// False if there is one of that name in this scope.
  bool add(std::string_view name, const DeckParameter& parameter);
  /// Notes a name whose definition cannot be read: where nothing else defines it, its uses cause no fault.
  void add_unreadable(std::string_view name);
  /// Null if there is none.
  [[nodiscard]] const DeckParameter* find(std::string_view name) const;
  [[nodiscard]] const ParameterLanguage& language() const { return language_; }
  [[nodiscard]] const DeckParameters* outer() const { return outer_; }

 private:
  ParameterLanguage language_;
  const DeckParameters* outer_;
  std::map<std::string, DeckParameter, std::less<>> parameters_;  ///< by names in lower case
  std::set<std::string, std::less<>> unreadable_;
};

/// The runs of letters, digits and _ in a text, which may be names.
std::vector<std::string_view> words_in(std::string_view text);

/// The value of a field, or the rule that it breaks; NaN without a rule if a parameter has a fault of its
/// own.
struct ParameterUse {
  double value = 0;
  std::string rule = {};
};
/// The value of &name, -&name, <expression> or -<expression>; absent for any other text.
std::optional<ParameterUse> parameter_use(std::string_view written, const DeckParameters& known);

/// A parameter as a deck defines it.
struct ParameterDefinition {
  std::string_view name;
  std::string_view value;  ///< a number or an expression
  std::size_t line = 0;
  bool is_expression = true;  ///< 1.5-3 is a difference, and not 0.0015
  bool is_whole = false;      ///< must be a whole number
};
/// Adds a parameter to `scope`, computed from those that are `known`. If it cannot be computed, a fault is
/// added, and its uses cause none. False after a fault.
bool define_parameter(const ParameterDefinition& definition, const DeckParameters& known,
                      DeckParameters& scope, MeasurementFaults& faults);

}  // namespace dashpad::input
