// The tables of measured tests: the made-up bytes stand in for each of them in turn.

#include <cmath>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <map>

#include "dashpad/report1986/validation/measured_tests.hpp"
#include "reading.hpp"

namespace fs = std::filesystem;
using namespace dashpad;
using namespace dashpad::fuzz;

namespace {

std::map<std::string, std::string> sound_tables() {
  std::map<std::string, std::string> tables;
  for (const fs::directory_entry& entry : fs::directory_iterator(DASHPAD_SOURCE_DIR "/data/validation")) {
    if (entry.path().extension() != ".csv") continue;
    std::ifstream stream(entry.path(), std::ios::binary);
    tables[entry.path().filename()] = {std::istreambuf_iterator<char>(stream),
                                       std::istreambuf_iterator<char>()};
    write(entry.path().filename(), tables[entry.path().filename()]);
  }
  return tables;
}

void require_sound(const std::optional<double>& number) {
  require(!number || (*number > 0 && std::isfinite(*number)), "a number is finite and more than 0");
}

void require_sound(const report1986::ValidationData& data) {
  for (const report1986::MeasuredTest& test : data.measured.tests)
    for (const auto& number :
         {std::optional{test.weight_lb}, std::optional{test.speed_mph}, std::optional{test.energy_in_lb},
          test.rebound_mph, test.time_to_peak_ms, test.total_time_ms, test.peak_force_lb, test.plug_strain,
          test.diameter_strain})
      require_sound(number);
  for (const report1986::UnplacedReadings& group : data.measured.unplaced)
    for (const double reading : group.readings) require_sound(std::optional{reading});
  for (const report1986::StaticPoint& point : data.load_cell)
    for (const double number : {point.deflection_in, point.force_lb}) require_sound(std::optional{number});
  for (const report1986::PrintedConstant& constant : data.printed)
    require_sound(std::optional{constant.value});
  require_sound(std::optional{data.plate_stiffness_lb_per_in});
  require_sound(std::optional{data.pad_thickness_in});
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  static const std::map<std::string, std::string> tables = sound_tables();
  for (const auto& [name, table] : tables) {
    write(name, text_of(bytes, size));
    std::vector<input::Fault> faults;
    const report1986::ValidationData data = report1986::read_validation_data(folder(), faults);
    fuzz::require_sound(faults);
    if (faults.empty()) require_sound(data);
    write(name, table);
  }
  return 0;
}
