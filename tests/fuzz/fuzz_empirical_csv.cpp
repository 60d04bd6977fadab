// Tables of measured values that a factor of a study is drawn from.

#include <algorithm>
#include <cstdint>

#include "reading.hpp"
#include "study/factor_spread.hpp"

using namespace dashpad;
using namespace dashpad::fuzz;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  const auto file = write("measured.csv", text_of(bytes, size));
  struct Column {
    const char* name;
    const char* unit;
  };
  for (const Column& column : {Column{"", "m/s"}, {"", "1"}, {"speed", "m/s"}, {"strain", "1"}})
    if (const auto values =
            read_or_refuse([&] { return study::read_empirical(file, column.name, column.unit).value(); })) {
      require_finite(*values, "measured values are finite");
      require(std::ranges::is_sorted(*values), "measured values are sorted");
    }
  return 0;
}
