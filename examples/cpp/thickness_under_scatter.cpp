// How thick must a pad be if foam and speed scatter? 256 draws at each thickness, on all cores and in memory.
//
//   thickness_under_scatter [FOLDER]      FOLDER has examples and materials; by default the working folder
//
// Prints, for each thickness, the peak that 95 % of the draws do not exceed, with its 95 % interval, and how
// many draws stay below 60 g:
//
//   25.0 mm: 75.1 g (72.3 to 77.5 g), 89 of 256 draws below 60 g
//   27.5 mm: 58.1 g (56.5 to 59.8 g), 251 of 256 draws below 60 g
//   30.0 mm: 48.8 g (48.5 to 49.7 g), 255 of 256 draws below 60 g
//   35.0 mm: 43.9 g (43.6 to 44.6 g), 256 of 256 draws below 60 g

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <thread>
#include <utility>
#include <vector>

#include "dashpad/input/case_file.hpp"
#include "dashpad/study/answers.hpp"
#include "dashpad/study/run_study.hpp"

namespace {

namespace study = dashpad::study;

/// The outcome of every row, with what the solver says of it: extrapolated, error, status.
std::vector<study::Outcome> outcomes_of(const study::Study& pads, const study::Design& design) {
  std::vector<study::Outcome> outcomes(design.rows());
  std::atomic<std::uint64_t> next = 0;
  std::vector<std::jthread> threads;
  for (unsigned i = 0; i < std::max(1U, std::thread::hardware_concurrency()); ++i)
    threads.emplace_back([&] {
      study::Worker worker(pads, design);  // each thread has its own, with a solver
      constexpr std::uint64_t size = 32;   // rows at a time
      for (std::uint64_t batch = next++; batch * size < design.rows(); batch = next++)
        for (study::StoredRow& row : worker.compute(batch, size)) outcomes[row.row] = std::move(row.outcome);
    });
  threads.clear();  // waits for all
  return outcomes;
}

}  // namespace

int main(int count, char** arguments) try {
  const std::filesystem::path folder = count > 1 ? arguments[1] : ".";
  study::Study pads;
  auto file =
      dashpad::input::read_case(folder / "examples/helmet-pad-10fps.toml", folder / "materials").value();
  pads.base = std::move(file.impact);
  const std::vector<double> thicknesses{0.025, 0.0275, 0.030, 0.035};
  pads.factors = {
      {.key = "pad.thickness", .unit = "m", .spread = study::Levels{thicknesses}},
      {.key = "pad.scale", .unit = "1", .spread = study::Normal{1, 0.1}, .lowest = 0.5},  // of the stress
      {.key = "impactor.speed", .unit = "m/s", .spread = study::Uniform{3.0, 3.2}},
  };
  pads.samples = 256;  // the same draws at each thickness
  pads.responses = {"peak_acceleration"};
  const study::Design design(pads);  // throws for a study that breaks a rule
  const std::vector<study::Outcome> outcomes = outcomes_of(pads, design);

  constexpr double g = dashpad::standard_gravity;
  for (std::size_t i = 0; i < thicknesses.size(); ++i) {
    std::vector<double> peaks;  // rows of one thickness follow one another
    for (std::size_t row = i * pads.samples; row < (i + 1) * pads.samples; ++row)
      peaks.push_back(outcomes[row].status == dashpad::Status::bottomed_out ? dashpad::infinite
                                                                            : outcomes[row].values.front());
    const auto kept = std::ranges::count_if(peaks, [](double peak) { return peak <= 60 * g; });  // not if NaN
    if (const auto peak = study::quantile(study::distribution(peaks), 0.95))
      std::printf("%.1f mm: %.1f g (%.1f to %.1f g), %td of 256 draws below 60 g\n", 1e3 * thicknesses[i],
                  peak->value / g, peak->low / g, peak->high / g, kept);
  }
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
