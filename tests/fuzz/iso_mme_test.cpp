#include "iso_mme_test.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include "dashpad/input/iso_mme/iso_mme.hpp"
#include "dashpad/output/deck/iso_mme_test.hpp"
#include "reading.hpp"

namespace dashpad::fuzz {

namespace {

constexpr std::size_t max_channels = 3;

void write_and_read(const injury::MeasuredPulse& read) {
  const double interval = read.pulse.time[1] - read.pulse.time[0];
  const output::IsoMmeTest test{.name = "again",
                                .time_of_first_sample = 0,
                                .sampling_interval = interval,
                                .histories = {{output::computed_acceleration_code, "Again", "Acceleration",
                                               "m/s2", read.pulse.acceleration}}};
  for (const auto& [name, text] : output::iso_mme_files(test))
    write("written" / std::filesystem::path(name), text);
  const injury::MeasuredPulse again = input::read_iso_mme(folder() / "written", {}).value().measured;
  require(again.pulse.acceleration == read.pulse.acceleration, "what is written is read as the same");
}

}  // namespace

void read_iso_mme_test(const std::filesystem::path& test) {
  const auto channels = read_or_refuse([&] { return input::iso_mme_channels(test).value(); });
  if (!channels) return;
  std::vector<input::PulseOptions> ways{
      {},
      {.resultant = true},
      {.channel = "11HEAD0000??AC?A", .acceleration_unit = "g", .resultant = true},
      {.sensitivity = {input::sensitivity_of("10 mV/g")}}};
  for (std::size_t i = 0; i < std::min(channels->size(), max_channels); ++i)
    ways.push_back({.channel = std::to_string((*channels)[i].number)});
  for (const input::PulseOptions& way : ways) {
    const auto read = read_or_refuse([&] { return input::read_iso_mme(test, way).value().measured; });
    if (!read) continue;
    check(read->pulse);
    for (const std::vector<double>& component : read->components) {
      require(component.size() == read->pulse.time.size(), "every sample has its components");
      require_finite(component, "components are finite");
    }
    write_and_read(*read);
  }
}

}  // namespace dashpad::fuzz
