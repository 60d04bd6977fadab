// dashpad study, interrupted in every way: the rows at the end are those of an undisturbed run.
//
// DASHPAD_KILL_ROWS and DASHPAD_KILLS set the size of the longest test: 100000 and 50 for the acceptance.

#include <bit>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <random>
#include <thread>

#include <fmt/format.h>

#include "command.hpp"
#include "dashpad/study/store.hpp"

namespace dashpad::test {
namespace {

using study::Store;
using study::StoredRow;

std::uint64_t setting(const char* name, std::uint64_t otherwise) {
  const char* text = std::getenv(name);
  return text == nullptr ? otherwise : std::stoull(text);
}

/// Bits and all, so that a missing value equals a missing value.
std::vector<std::uint64_t> bits(const StoredRow& row) {
  std::vector<std::uint64_t> all = {
      row.row, static_cast<std::uint64_t>(row.outcome.status), std::uint64_t{row.outcome.extrapolated},
      std::uint64_t{row.outcome.bottomed}, std::bit_cast<std::uint64_t>(row.outcome.error)};
  for (const auto* values : {&row.factors, &row.outcome.values})
    for (const double value : *values) all.push_back(std::bit_cast<std::uint64_t>(value));
  return all;
}

class StudyKill : public CommandTest {
 protected:
  void SetUp() override {
    CommandTest::SetUp();
    write_file(file("study.toml"), fmt::format(R"(title = "Interrupted"
case = "case.toml"
samples = {}
sampling = "monte-carlo"
seed = 7
responses = ["peak_force", "peak_strain", "rebound_speed", "release"]
[factors."impactor.speed"]
distribution = "normal"
mean = "3 m/s"
deviation = "0.3 m/s"
[factors."pad.thickness"]
distribution = "uniform"
low = "40 mm"
high = "60 mm"
)",
                                               rows_));
  }

  [[nodiscard]] std::vector<std::string> study(const std::string& store) const {
    return {"study", file("study.toml"), "--out", file(store), "--quiet"};
  }

  /// Starts the study and kills it after a time. False where it had ended before.
  [[nodiscard]] bool kill_after(const std::string& store, std::chrono::microseconds time) const {
    std::vector<std::string> arguments = study(store);
    arguments.insert(arguments.begin(), DASHPAD_COMMAND);
    std::vector<char*> words;
    for (std::string& argument : arguments) words.push_back(argument.data());
    words.push_back(nullptr);
    pid_t process = 0;
    if (::posix_spawn(&process, DASHPAD_COMMAND, nullptr, nullptr, words.data(), environ) != 0)
      throw std::runtime_error("the command cannot be started");
    std::this_thread::sleep_for(time);
    ::kill(process, SIGKILL);
    int status = 0;
    ::waitpid(process, &status, 0);
    return WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL;
  }

  /// Rows that a killed run left; none where it came to nothing.
  [[nodiscard]] std::uint64_t rows_in(const std::string& store) const {
    try {
      return Store::open_to_read(file(store)).rows_done();
    } catch (const std::runtime_error& error) {
      const std::string why = error.what();
      EXPECT_TRUE(why.find("no such file") != std::string::npos || why.find("is empty") != std::string::npos)
          << why;
      return 0;
    }
  }

  void expect_same_stores(const std::string& got, const std::string& expected) const {
    const Store first = Store::open_to_read(file(got)), second = Store::open_to_read(file(expected));
    ASSERT_EQ(second.rows_done(), rows_);
    ASSERT_EQ(first.rows_done(), rows_);
    std::vector<std::vector<std::uint64_t>> rows;
    second.visit_rows([&](const StoredRow& row) { rows.push_back(bits(row)); });
    std::size_t i = 0, differing = 0;
    first.visit_rows([&](const StoredRow& row) { differing += bits(row) != rows.at(i++) ? 1 : 0; });
    EXPECT_EQ(i, rows_);
    EXPECT_EQ(differing, 0U);
  }

  std::uint64_t rows_ = setting("DASHPAD_KILL_ROWS", 3000);
};

TEST_F(StudyKill, at_random_moments_costs_no_row_and_doubles_none) {
  const std::uint64_t wanted = setting("DASHPAD_KILLS", 12);
  const auto begin = std::chrono::steady_clock::now();
  ASSERT_EQ(dashpad(study("whole.db")).exit_code, 0);
  const std::chrono::duration<double> whole = std::chrono::steady_clock::now() - begin;

  // On a machine that has become faster the study is over before its kills: then it is checked, and another
  // one is killed sooner.
  std::mt19937_64 random{std::random_device{}()};
  double longest = 2 * whole.count() / static_cast<double>(wanted);
  std::uint64_t kills = 0, before = 0;
  while (kills < wanted) {
    const double moment = std::uniform_real_distribution<double>(0, longest)(random);
    if (kill_after("killed.db", std::chrono::microseconds(static_cast<std::int64_t>(1e6 * moment)))) {
      ++kills;
      const std::uint64_t now = rows_in("killed.db");
      ASSERT_GE(now, before) << "kill " << kills;
      before = now;
    } else {
      expect_same_stores("killed.db", "whole.db");
      fs::remove(file("killed.db"));
      before = 0;
      longest /= 2;
    }
  }
  RecordProperty("kills", static_cast<int>(kills));
  RecordProperty("rows_before_the_last_run", static_cast<int>(before));
  const Outcome last = dashpad(study("killed.db"));
  ASSERT_EQ(last.exit_code, 0) << last.err;
  expect_same_stores("killed.db", "whole.db");
  EXPECT_FALSE(fs::exists(file("killed.db-wal")));
  EXPECT_FALSE(fs::exists(file("killed.db-shm")));
}

TEST_F(StudyKill, by_a_full_disk_keeps_the_rows_and_goes_on) {
  const Outcome full = shell("ulimit -f 300; exec \"$DASHPAD\" study '" + file("study.toml") + "' --out '" +
                             file("full.db") + "' --quiet");
  EXPECT_EQ(full.exit_code, 1);
  EXPECT_NE(full.err.find("all rows written so far are kept"), std::string::npos) << full.err;
  const std::uint64_t kept = rows_in("full.db");
  EXPECT_LT(kept, rows_);
  ASSERT_EQ(dashpad(study("full.db")).exit_code, 0);
  ASSERT_EQ(dashpad(study("whole.db")).exit_code, 0);
  expect_same_stores("full.db", "whole.db");
}

TEST_F(StudyKill, leaves_out_a_second_run_at_the_same_time) {
  const Outcome both =
      shell("\"$DASHPAD\" study '" + file("study.toml") + "' --out '" + file("s.db") +
            "' --quiet & first=$!; sleep 0.1; \"$DASHPAD\" study '" + file("study.toml") + "' --out '" +
            file("s.db") + "' --quiet; second=$?; wait $first; echo $? $second");
  // The one is refused while the other runs, whichever came first; on a fast machine the first may be over.
  if (both.out.find("0 2") != std::string::npos || both.out.find("2 0") != std::string::npos) {
    EXPECT_NE(both.err.find("another run is writing to it"), std::string::npos) << both.err;
  } else {
    EXPECT_NE(both.out.find("0 0"), std::string::npos) << both.out << both.err;
  }
  ASSERT_EQ(dashpad(study("whole.db")).exit_code, 0);
  expect_same_stores("s.db", "whole.db");
}

}  // namespace
}  // namespace dashpad::test
