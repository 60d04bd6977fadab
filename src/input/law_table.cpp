#include "input/law_table.hpp"

#include "input/parameter_table.hpp"

namespace dashpad::input {

std::optional<PadLaw> read_law(TableReader& table) {
  const auto law = read_alternative<PadLaw>(table, "law");
  auto parameters = table.table("parameters");
  if (!parameters || !law) return std::nullopt;
  const PadLaw result = with_parameters(*law, *parameters);
  parameters->refuse_others();
  return result;
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

}  // namespace dashpad::input
