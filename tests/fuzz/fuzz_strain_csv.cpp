// Strain histories.

#include <cstdint>

#include <fmt/format.h>

#include "dashpad/input/measurement/tables.hpp"
#include "reading.hpp"

using namespace dashpad;
using namespace dashpad::fuzz;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  const auto table = read_or_refuse(
      [&] { return input::read_strain_csv(write("strains.csv", text_of(bytes, size))).value(); });
  if (!table) return 0;
  require(table->time.size() >= 2 && table->time.size() <= 10'000, "a history has 2 to 10,000 rows");
  require(table->time.size() == table->strain.size(), "every time has a strain");
  require_increasing(table->time, "times increase");
  require(table->time.front() == 0 && table->strain.front() == 0, "a history begins at 0 with strain 0");
  for (const double strain : table->strain) require(strain >= 0 && strain < 1, "a strain is in [0, 1)");
  for (const std::string& remark : table->remarks) require_plain_text(remark, "a remark is plain text");

  std::string written = "time_s,strain\n";
  for (std::size_t i = 0; i < table->time.size(); ++i)
    written += fmt::format("{},{}\n", table->time[i], table->strain[i]);
  const input::StrainTable again = input::read_strain_csv(write("again.csv", written)).value();
  require(again.time == table->time && again.strain == table->strain, "what is written is read as the same");
  return 0;
}
