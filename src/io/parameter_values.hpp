#pragma once
/// The parameters of a law of any kind, as a list: what writers of results and listings go through.

#include <string>
#include <variant>
#include <vector>

#include "dashpad/pad/law.hpp"

namespace dashpad {

struct ParameterValue {
  std::string key;
  std::string symbol;
  std::string unit;  ///< SI; "1" for a pure number
  double value = 0;  ///< in that unit
  std::string meaning;
};

inline std::vector<ParameterValue> parameter_values(const PadLaw& law) {
  return std::visit(
      []<class Law>(const Law& of) {
        std::vector<ParameterValue> values;
        for (const Parameter<Law>& parameter : Law::parameters)
          values.push_back(
              {parameter.key, parameter.symbol, parameter.unit, of.*(parameter.member), parameter.meaning});
        return values;
      },
      law);
}

}  // namespace dashpad
