/// A fit that is stopped goes on where it was, and takes the state of no other.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <fstream>
#include <regex>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>

#include "dashpad/fit/report.hpp"
#include "model/pad/foam/foam_memo.hpp"
#include "model/pad/foam/foam_stress.hpp"
#include "shared/synthetic_fits.hpp"
#include "shared/temporary_folder.hpp"

namespace dashpad::fit {
namespace {

using testing::HasSubstr;

struct FitStateTest : testing::Test {
  FitStateTest() { made.fit.starts = 3; }
  [[nodiscard]] RunOptions options(const char* fingerprint = "a") const {
    return {.state = folder.path() / "fit.state", .fingerprint = fingerprint};
  }
  test::TemporaryFolder folder;
  test::SyntheticFit made = test::hyperfoam_rates(3);
};

TEST_F(FitStateTest, GoesOnAndFindsTheSame) {
  const FitReport whole = run_fit(made.fit);
  std::atomic<bool> stop = false;
  RunOptions cut = options();
  cut.stop = &stop;
  std::size_t pieces = 0;
  cut.progress = [&](const char*, std::size_t done, std::size_t) {
    if (done > 0 && ++pieces == 2) stop = true;
  };
  std::size_t kept = 0;
  try {
    run_fit(made.fit, cut);
  } catch (const Stopped& stopped) {
    kept = stopped.kept();
  }
  ASSERT_GE(kept, 2U);
  const FitReport rest = run_fit(made.fit, options());
  ASSERT_TRUE(rest.converged);
  EXPECT_LT(rest.evaluations, whole.evaluations);
  for (std::size_t i = 0; i < whole.unknowns.size(); ++i) {
    EXPECT_EQ(rest.unknowns[i].value, whole.unknowns[i].value);
    EXPECT_EQ(rest.unknowns[i].low, whole.unknowns[i].low);
    EXPECT_EQ(rest.unknowns[i].high, whole.unknowns[i].high);
  }
  // All is kept now: nothing is searched again.
  EXPECT_LT(run_fit(made.fit, options()).evaluations, rest.evaluations / 2);
}

TEST_F(FitStateTest, RefusesTheStateOfAnotherFitAndWhatIsNone) {
  run_fit(made.fit, options());
  try {
    check_state(made.fit, options("b"));
    ADD_FAILURE() << "the state of a different fit was accepted";
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), HasSubstr("fit.state: is the state of a different fit"));
  }
  for (const char* text : {"", "{}", "[1]", "title = \"case\"", R"({"format": "dashpad fit state 3"})"}) {
    std::ofstream(folder.path() / "fit.state") << text;
    EXPECT_THROW(check_state(made.fit, options()), std::runtime_error) << text;
  }
}

TEST_F(FitStateTest, RefusesTheStateOfAnEarlierVersion) {
  std::ofstream(folder.path() / "fit.state")
      << R"({"format": "dashpad fit state 2", "fit": "a", "pieces": {}})";
  try {
    check_state(made.fit, options());
    ADD_FAILURE() << "it was taken";
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), HasSubstr("fit.state: is a fit state from an earlier version"));
  }
}

/// Numbers of other kinds and sizes, and plausible ones that no search has found.
TEST_F(FitStateTest, RefusesWhatWasChanged) {
  run_fit(made.fit, options());
  std::ostringstream read;
  read << std::ifstream(folder.path() / "fit.state").rdbuf();
  const std::string state = read.str();
  const std::regex misfit("\"misfit\": [-+.e0-9]+"), place("\"x\": [-+.e0-9]+"),
      first("\"x\": \\[\\s*[-+.e0-9]+");
  for (const char* value : {"\"a\"", "[]", "{}", "null", "true", "1e300", "-1", "0.5"})
    for (const auto& [part, key] :
         {std::pair{&misfit, "\"misfit\": "}, {&place, "\"x\": "}, {&first, "\"x\": ["}}) {
      const std::string changed =
          std::regex_replace(state, *part, std::string(key) + value, std::regex_constants::format_first_only);
      ASSERT_NE(changed, state);
      std::ofstream(folder.path() / "fit.state") << changed;
      EXPECT_THAT(
          [&] { check_state(made.fit, options()); },
          testing::ThrowsMessage<std::runtime_error>(HasSubstr("fit.state: is not a valid fit state: ")))
          << key << value;
    }
}

TEST_F(FitStateTest, StopsWithoutAStateAsWell) {
  const std::atomic<bool> stop = true;
  EXPECT_THROW(run_fit(made.fit, {.stop = &stop}), Stopped);
}

/// Whatever was asked before, the memo gives what is made without it.
TEST(FoamMemo, GivesWhatWouldBeMade) {
  FoamMemo memo;
  for (int i = 0; i < 200; ++i) {
    Foam foam;
    foam.unloading_factor = 0.1 * (i % 5);
    foam.unloading_shape = 0.5 + 0.5 * (i % 7);
    foam.curves.base = HyperfoamCurve{50e3 + 1e3 * (i % 40), 8, 5e3, -1, 0.65};
    foam.curves.slowest_rate = 0.01;
    const FoamStress plain(foam), remembered(foam, &memo);
    for (const double strain : {0.01, 0.3, 0.6, 0.7})
      for (const double ahead : {0.0, 0.02})
        ASSERT_EQ(plain.stress(strain_of(strain), ahead, 0), remembered.stress(strain_of(strain), ahead, 0));
  }
}

}  // namespace
}  // namespace dashpad::fit
