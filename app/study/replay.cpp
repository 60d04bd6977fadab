// dashpad study replay: solves one row of a store again, with its history.

#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "dashpad/output/study.hpp"
#include "dashpad/study/run_study.hpp"
#include "dashpad/study/study_file.hpp"
#include "quantities/from_chars.hpp"
#include "result_files.hpp"
#include "study/study.hpp"

namespace dashpad::app {

namespace {

constexpr const char* study_replay_footer = R"(Examples:
  dashpad study examples/studies/speed-and-thickness.toml --out replayed.db
  dashpad study replay replayed.db 17
  dashpad study replay replayed.db 17 --units us --csv row-17.csv --png row-17.png
  dashpad study replay replayed.db 17 --report row-17.html

Rows are numbered from 0. The store contains everything that the row depends on; neither the study file nor any
material card is needed. The row is solved again, and its responses are compared with the stored ones.

Exit codes: 0 success, the stored responses were reproduced; 1 a result could not be written; 2 invalid input
(nothing was run); 3 the row does not meet the tolerance, or its stored responses were not reproduced.)";

struct StudyReplayRequest {
  std::string store_file;
  std::string row;
  OutputFiles files;
};

/// A row as stored and as solved again.
struct Replay {
  study::StoredRow stored;
  std::vector<double> factors;  ///< as the study defines them
  study::Outcome again;
  ImpactCase impact;
  Options options;
  Solution solution;
  std::vector<Blow> blows = {};
};

study::StoredRow stored_row(const study::Store& store, const StudyReplayRequest& request) {
  const auto number = parsed<std::uint64_t>(request.row);
  if (!number || *number >= store.rows())
    throw Refused(
        {fmt::format("ROW {}: must be a whole number from 0 to {}, the last row of {}",
                     request.row.empty() ? "\"\"" : request.row, store.rows() - 1, request.store_file)});
  std::optional<study::StoredRow> row = store.row(*number);
  if (!row)
    throw Refused({fmt::format("ROW {}: has not been computed yet; {} has {} of {} rows", request.row,
                               request.store_file, store.rows_done(), store.rows())});
  return *std::move(row);
}

Replay replay(const study::Store& store, const StudyReplayRequest& request) {
  Replay result;
  result.stored = stored_row(store, request);
  const study::Study study = study::stored_study(store);
  const study::Design design{study};
  result.factors.resize(result.stored.factors.size());
  design.factors_of(result.stored.row, result.factors);
  study::Worker worker{study, design};
  try {
    result.impact = worker.case_of(result.stored.row);
    result.solution = worker.replay(result.stored.row, result.again);
  } catch (const std::invalid_argument& error) {
    throw Refused({fmt::format("ROW {}: its factors give an invalid case: {}", request.row, error.what())});
  }
  result.options = study.options;
  if (result.impact.blows) result.blows = solve_blows(result.impact, result.options);
  return result;
}

std::string with_all_digits(double value) { return std::isnan(value) ? "none" : fmt::format("{}", value); }

/// Whether the bits are the same, or neither has a value.
bool are_same(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }

std::vector<std::string> differences(const Replay& replay, const study::Store& store) {
  std::vector<std::string> found;
  const auto compare = [&found](const std::vector<study::StoredColumn>& columns, const auto& before,
                                const auto& now) {
    for (std::size_t i = 0; i < columns.size(); ++i)
      if (!are_same(before[i], now[i]))
        found.push_back(fmt::format("{}: stored {}, now {} {}", columns[i].name, with_all_digits(before[i]),
                                    with_all_digits(now[i]), columns[i].unit));
  };
  compare(store.factors(), replay.stored.factors, replay.factors);
  if (replay.stored.outcome.status != replay.again.status)
    found.push_back(fmt::format("status: stored \"{}\", now \"{}\"", to_string(replay.stored.outcome.status),
                                to_string(replay.again.status)));
  compare(store.responses(), replay.stored.outcome.values, replay.again.values);
  return found;
}

std::string heading(const Replay& replay, const study::Store& store, const UnitSystem& units) {
  std::string text = fmt::format("Row {}:", replay.stored.row);
  for (std::size_t i = 0; i < replay.stored.factors.size(); ++i)
    text += fmt::format(
        "{} {} = {}", i == 0 ? "" : ",", store.factors()[i].name,
        output::shown_factor(store.factors()[i].unit, replay.factors[i], replay.impact.pad.material, units));
  return text + "\n\n";
}

std::string verdict(const std::vector<std::string>& differences, const study::Store& store) {
  std::string drawn;  // errors that move figures, not the impact
  for (const study::StoredColumn& factor : store.factors())
    if (factor.name == "foam.misfit" || factor.name == "foam.neighbours")
      drawn += (drawn.empty() ? "" : " and ") + factor.name;
  if (differences.empty())
    return "\nThe stored responses were reproduced to the last bit.\n" +
           (drawn.empty() ? "" : fmt::format("They include {}, the figures above do not.\n", drawn));
  std::string text =
      fmt::format("\nDIFFERENT: the responses stored by Dashpad {} were not reproduced:\n", store.program());
  for (const std::string& line : differences) text += "  " + line + "\n";
  return text;
}

int run_replay(const StudyReplayRequest& request) {
  const study::Store store = open_stored(request.store_file);
  std::vector<std::string> errors;
  judge_result_files(request.files, files_of_store(request.store_file), errors);
  if (!errors.empty()) throw Refused(std::move(errors));
  const Replay result = replay(store, request);
  const std::vector<std::string> different = differences(result, store);
  publish(request.files, {result.impact, result.options, result.solution, result.blows},
          heading(result, store, unit_system(request.files.units)), verdict(different, store));
  return different.empty() ? exit_code(result.solution.summary) : exit_not_trusted;
}

}  // namespace

void add_study_replay(CLI::App& study, Action& action) {
  const auto [sub, request] = add_subcommand<StudyReplayRequest>(
      study, action, "replay", "Solve one row again, with its full history", study_replay_footer, run_replay);
  add_option(sub, "FILE", request.store_file, "The store of a study")->required();
  add_option(sub, "ROW", request.row, "Row number, counting from 0")->required();
  add_result_files(sub, request.files);
  add_force(sub, request.files.force);
}

}  // namespace dashpad::app
