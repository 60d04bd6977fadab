// Pulses in tables, and what is done to them next: the sensor's offset and the filter.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <stdexcept>

#include <fmt/format.h>

#include "dashpad/injury/cfc_filter.hpp"
#include "dashpad/injury/measured_pulse.hpp"
#include "dashpad/input/measurement/tables.hpp"
#include "reading.hpp"

namespace fs = std::filesystem;
using namespace dashpad;
using namespace dashpad::fuzz;

namespace {

const std::vector<input::PulseOptions>& ways_to_read() {
  static const std::vector<input::PulseOptions> ways{
      {},
      {.time = "1", .acceleration = {"2"}, .time_unit = "ms", .acceleration_unit = "g", .bridge_gaps = true},
      {.resultant = true, .bridge_gaps = true},
      {.sensitivity = {input::sensitivity_of("10 mV/g")}, .interval = 1e-4},
      {.acceleration_unit = "m/s2", .interval = 1e-4},
      {.bridge_gaps = true, .cut = {.from = 1e-3, .to = 5e-3}}};
  return ways;
}

bool are_ordinary(const std::vector<double>& values) {
  return std::ranges::all_of(values, [](double value) { return std::abs(value) < 1e100; });
}

/// Numbers near the largest may overflow here; all others must not.
void process(const injury::MeasuredPulse& read) {
  const bool ordinary = are_ordinary(read.pulse.time) && are_ordinary(read.pulse.acceleration);
  if (const auto offset = injury::offset_before_impact(read)) {
    const injury::MeasuredPulse zeroed = injury::zeroed(read, *offset);
    if (ordinary) check(zeroed.pulse);
  }
  try {
    const Pulse filtered = injury::cfc_filtered(read.pulse, 180);
    if (ordinary) require_finite(filtered.acceleration, "a filtered pulse is finite");
  } catch (const std::invalid_argument&) {  // uneven or too few samples
  }
}

void write_and_read(const Pulse& pulse) {
  std::string written = "time_s,acceleration_m_per_s2\n";
  for (std::size_t i = 0; i < pulse.time.size(); ++i)
    written += fmt::format("{},{}\n", pulse.time[i], pulse.acceleration[i]);
  const Pulse again =
      input::read_pulse_csv(write("again.csv", written), {.bridge_gaps = true}).value().measured.pulse;
  require(again.time == pulse.time && again.acceleration == pulse.acceleration,
          "what is written is read as the same");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  const fs::path file = write("pulse.csv", text_of(bytes, size));
  read_or_refuse([&] { return input::pulse_csv_columns(file).value(); });
  for (const input::PulseOptions& way : ways_to_read()) {
    const auto read = read_or_refuse([&] { return input::read_pulse_csv(file, way).value().measured; });
    if (!read) continue;
    check(read->pulse);
    for (const std::vector<double>& component : read->components) {
      require(component.size() == read->pulse.time.size(), "every sample has its components");
      require_finite(component, "components are finite");
    }
    for (const std::string& remark : read->remarks) require(!remark.empty(), "a remark says something");
    process(*read);
    write_and_read(read->pulse);
  }
  return 0;
}
