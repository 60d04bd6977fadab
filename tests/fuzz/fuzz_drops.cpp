// Tables of drops, and the heights that follow from them.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "dashpad/fall_height/fall_height.hpp"
#include "dashpad/input/standard_file.hpp"
#include "dashpad/output/fall_height.hpp"
#include "reading.hpp"

namespace fs = std::filesystem;
using namespace dashpad;
using namespace dashpad::fuzz;

namespace {

void require_sound_answer(const fall_height::Answer& answer) {
  for (const fall_height::Place& place : answer.places)
    for (const fall_height::Crossing& crossing : place.crossings) {
      require(!crossing.height || (*crossing.height > 0 && std::isfinite(*crossing.height)),
              "a height is finite");
      require(!crossing.is_enclosed() || (crossing.height && *crossing.below <= *crossing.above),
              "drops enclose a height from below and above");
      if (crossing.height && crossing.interval)
        require(crossing.interval->first <= *crossing.height * (1 + 1e-9) &&
                    *crossing.height <= crossing.interval->second * (1 + 1e-9),
                "an interval has its height");
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  static const std::vector<injury::Standard> standards = [] {
    const fs::path presets = fs::path(DASHPAD_SOURCE_DIR) / "standards";
    return std::vector{input::read_standard(presets / "en-1177.toml").value(),
                       input::read_standard(presets / "astm-f1292.toml").value()};
  }();
  const fs::path file = write("drops.csv", text_of(bytes, size));
  for (const injury::Standard& standard : standards) {
    auto table = read_or_refuse([&] { return fall_height::read_drops(file, standard).value(); });
    // Without its pulse a drop has no figures.
    if (!table || std::ranges::any_of(table->drops, [](const auto& drop) { return !drop.pulse.empty(); }))
      continue;
    output::FallHeightReport report{.measured = fall_height::evaluated(*table, standard),
                                    .table_file = "drops.csv"};
    require_sound_answer(*report.measured);
    require_plain_text(output::fall_height_answer(report, unit_system("si")), "an answer is plain text");
    require(!output::fall_height_csv(report).empty(), "drops are a table");
  }
  return 0;
}
