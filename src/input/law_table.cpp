#include "input/law_table.hpp"

#include "input/foam_tables.hpp"
#include "input/parameter_table.hpp"

namespace dashpad::input {
namespace {

/// Whether a law can do without the table of its numbers.
bool may_lack_parameters(const PadLaw& law) {
  return std::visit(
      []<class Law>(const Law&) {
        for (const auto& parameter : Law::parameters)
          if (!parameter.may_be_left_out()) return false;
        return true;
      },
      law);
}

}  // namespace

std::optional<PadLaw> read_law(TableReader& table) {
  auto law = read_alternative<PadLaw>(table, "law");
  auto parameters =
      table.table("parameters", law && may_lack_parameters(*law) ? Presence::optional : Presence::required);
  if (!law) return std::nullopt;
  // Known, whatever else is missing.
  for (const char* key : {"curve", "rate", "unloading"})
    if (has_curves(*law)) table.has(key);
  if (parameters) {
    law = with_parameters(*law, *parameters);
    parameters->refuse_others();
  } else if (!may_lack_parameters(*law)) {
    return std::nullopt;
  }
  const bool sound = std::visit(
      [&]<class Law>(Law& of) {
        if constexpr (SharesSlip<Law>)
          return read_foam_tables(table, of);
        else
          return true;
      },
      *law);
  return sound ? law : std::nullopt;
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
