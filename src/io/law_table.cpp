#include "io/law_table.hpp"

#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace dashpad {
namespace {

template <class Law>
Law read_parameters(TableReader& table) {
  Law law;
  for (const Parameter<Law>& parameter : Law::parameters)
    law.*parameter.member = std::string_view(parameter.unit) == "1"
                                ? table.number(parameter.key)
                                : table.quantity(parameter.key, parameter.unit);
  return law;
}

struct LawReader {
  std::string name;
  PadLaw (*read)(TableReader&);
};

template <std::size_t... index>
std::vector<LawReader> law_readers(std::index_sequence<index...>) {
  return {LawReader{std::variant_alternative_t<index, PadLaw>::name, [](TableReader& table) {
                      return PadLaw(read_parameters<std::variant_alternative_t<index, PadLaw>>(table));
                    }}...};
}

}  // namespace

std::optional<PadLaw> read_law(TableReader& table) {
  const auto readers = law_readers(std::make_index_sequence<std::variant_size_v<PadLaw>>());
  std::vector<std::string> names;
  for (const LawReader& reader : readers) names.push_back(reader.name);
  const std::string name = table.choice("law", names);
  auto parameters = table.table("parameters");
  if (!parameters) return std::nullopt;
  for (const LawReader& reader : readers) {
    if (reader.name != name) continue;
    const PadLaw law = reader.read(*parameters);
    parameters->refuse_others();
    return law;
  }
  return std::nullopt;
}

std::optional<FittedRange> read_fitted(TableReader& table) {
  auto fitted = table.table("fitted", Presence::optional);
  if (!fitted) return std::nullopt;
  const FittedRange range{.highest_strain = fitted->number("highest_strain"),
                          .lowest_rate = fitted->quantity("lowest_rate", "1/s"),
                          .highest_rate = fitted->quantity("highest_rate", "1/s")};
  fitted->refuse_others();
  return range;
}

}  // namespace dashpad
