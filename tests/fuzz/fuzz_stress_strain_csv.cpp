// Compression tests for fits and for cards.

#include <algorithm>
#include <cstdint>

#include "dashpad/input/material_deck.hpp"
#include "dashpad/input/measurement/tables.hpp"
#include "reading.hpp"

using namespace dashpad;
using namespace dashpad::fuzz;

namespace {
const input::StressStrainColumns specimen{.thickness = 0.025, .area = 25e-4};
}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  const auto file = write("test.csv", text_of(bytes, size));
  for (const input::StressStrainColumns& columns :
       {input::StressStrainColumns{}, input::StressStrainColumns{.time = "time"},
        input::StressStrainColumns{.strain_unit = "percent", .stress_unit = "MPa"}, specimen}) {
    const auto table = read_or_refuse([&] { return input::read_stress_strain_csv(file, columns).value(); });
    if (!table) continue;
    require(table->strain.size() >= 2 && table->strain.size() <= 10'000, "a test has 2 to 10,000 rows");
    require(table->strain.size() == table->stress.size(), "every strain has a stress");
    require(table->time.empty() == columns.time.empty(), "times are there if they are asked for");
    require_increasing(table->time, "times increase");
    require_finite(table->stress, "stresses are finite");
    for (const double strain : table->strain) require(strain < 1, "a strain is below 1");
    require(std::ranges::max(table->strain) > 0, "a test compresses");
  }
  input::is_stress_table(file);
  for (const std::vector<double>& rates : {std::vector<double>{}, {0.01}})
    if (const auto made =
            read_or_refuse([&] { return input::read_stress_tables({file}, {rates}, specimen).value(); }))
      require(violations(made->material).empty(), "a foam of tests keeps its rules");
  return 0;
}
