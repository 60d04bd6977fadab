#pragma once
/// What compression tests measured.

#include <algorithm>
#include <iterator>

#include "dashpad/fit/proposal.hpp"
#include "dashpad/input/material_deck.hpp"

namespace dashpad::fit {

/// What was read; adds its faults.
template <class T>
std::optional<T> taken(input::Reading<T> reading, std::vector<input::Fault>& faults) {
  if (reading) return *std::move(reading);
  std::ranges::copy(reading.faults(), std::back_inserter(faults));
  return std::nullopt;
}

/// Tests as they were read, and what they show.
struct ReadTests {
  std::vector<TestSource> sources;
  std::vector<MaterialMeasurement> measurements;
  std::vector<Evidence> evidence;
};

/// The tests in the files: one for each, or for each column of stress with a rate in its header. A file that
/// states no rate counts by its times. Adds faults.
ReadTests read_tests(const std::vector<std::filesystem::path>& files, std::span<const double> rates,
                     const input::StressStrainColumns& wanted, std::vector<input::Fault>& faults);

}  // namespace dashpad::fit
