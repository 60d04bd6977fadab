/// The program of 1984 gives the very bits that it gave before, in every arithmetic, with its defects and
/// mended: tests/regression/spit1984-bits.txt. Nothing in it may depend on the processor.
///
/// After a change that is meant to change numbers: DASHPAD_REGENERATE=1 test_regression.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <bit>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include "dashpad/input/case_file.hpp"
#include "dashpad/spit1984/run.hpp"
#include "shared/samples.hpp"

namespace dashpad::test {
namespace {

using namespace spit1984;

const std::filesystem::path golden = source_folder / "tests/regression/spit1984-bits.txt";

/// FNV-1a over the bits of every number of the history.
std::uint64_t fingerprint(const spit1984::Run& run) {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const Step& step : run.history)
    for (const double value : {step.time_ms, step.force_lb, step.acceleration_g, step.speed_in_per_s,
                               step.motion_in, step.penetration_in}) {
      auto bits = std::bit_cast<std::uint64_t>(value);
      if (std::isnan(value)) bits = 0;  // the sign and the rest of a NaN are nobody's promise
      for (int byte = 0; byte < 8; ++byte) {
        hash = (hash ^ (bits & 0xff)) * 0x100000001b3;
        bits >>= 8;
      }
    }
  return hash;
}

ImpactCase sample(const PadLaw& law) {
  ImpactCase impact;
  impact.impactor = {.mass = 4.53592370, .nose = Sphere{0.0762}, .speed = 4.4704};
  impact.pad.thickness = 0.0508;
  impact.pad.material.law = law;
  impact.support = Support::linear(105076.1);
  return impact;
}

std::vector<std::pair<std::string, Deck>> decks() {
  std::vector<std::pair<std::string, Deck>> all;
  for (const char* name : {"dashboard-20mph", "dashboard-20mph-21-parameter", "load-cell-drop"})
    all.emplace_back(name,
                     deck_of(input::read_case(source_folder / "examples" / (std::string{name} + ".toml"),
                                              source_folder / "materials")
                                 .value()
                                 .impact));
  all.emplace_back("elastic", deck_of(sample(sample_law<Elastic>())));
  all.emplace_back("linear-viscoelastic", deck_of(sample(sample_law<LinearViscoelastic>())));
  all.emplace_back("rigid-foam", deck_of(sample(sample_law<RigidFoam>())));
  return all;
}

std::string line(const std::string& name, const Deck& deck, const Settings& settings) {
  const spit1984::Run result = run(deck, settings);
  return fmt::format(
      "{} {} {}: abend {}, {} steps, {} trials, {} stations, peak {:a} lbf, end {:a} mph, {:016x}\n", name,
      to_string(settings.arithmetic), settings.defects == all_mended ? "mended" : "faithful",
      static_cast<int>(result.abend), result.history.size(), result.trials, result.max_stations,
      result.peak_force_lb, result.rebound_speed_mph, fingerprint(result));
}

std::string all_runs() {
  std::string text;
  for (const auto& [name, deck] : decks())
    for (const Arithmetic arithmetic : {Arithmetic::pdp10, Arithmetic::binary32, Arithmetic::binary64})
      for (const Defects& defects : {Defects{}, all_mended}) {
        Settings settings;
        settings.arithmetic = arithmetic;
        settings.defects = defects;
        text += line(name, deck, settings);
      }
  return text;
}

TEST(Spit1984Goldens, EveryModeGivesTheSameBits) {
  const std::string now = all_runs();
  if (std::getenv("DASHPAD_REGENERATE") != nullptr) std::ofstream(golden) << now;
  std::ifstream file(golden);
  std::ostringstream before;
  before << file.rdbuf();
  EXPECT_EQ(now, before.str());
}

}  // namespace
}  // namespace dashpad::test
