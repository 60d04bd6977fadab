// dashpad batch: cases from a stream of JSON, answers as they are solved.

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

#include <unistd.h>

#include "command.hpp"
#include "dashpad/injury/figures.hpp"
#include "dashpad/input/case_file.hpp"
#include "dashpad/output/impact.hpp"
#include "dashpad/uncertainty/intervals.hpp"
#include "input/fault_json.hpp"
#include "output.hpp"

namespace dashpad::app {

namespace {

constexpr const char* batch_footer = R"(Examples:
  dashpad batch cases.jsonl > answers.jsonl
  echo '{"id": 1, "case": "examples/dashboard-20mph.toml", "set": {"pad.thickness": "30 mm"}}' | dashpad batch -

Each line of FILE is a case as a JSON object: either a case file and changes as for --set (see the example), or the
tables of a case file ({"impactor": {...}, "pad": {...}, "support": {...}}), with values written as in the file. "id"
is returned with the answer. File names are relative to FILE or, for standard input, to the working folder.

Each answer is one line on standard output, written before the next line is read: {"id": ..., "line": ..., then the
entries of "dashpad run --json"} or, if the line has errors, {"id": ..., "line": ..., "faults": [{"file", "line",
"key", "value", "rule"}, ...]}; the other lines are still solved. To solve a table of many cases on all cores, use a
study with rows = "table.csv" (dashpad study --help).

Exit codes: 0 every case has an answer, 1 an answer could not be written, 2 at least one line has errors, 3 at
least one result does not meet the tolerance.)";

struct BatchRequest {
  std::string file;
  std::string materials;
  std::optional<std::string> tolerance;
  bool no_intervals = false;
};

constexpr std::size_t longest_line = std::size_t{1} << 20;  // bytes

/// The next line, cut after `longest_line` bytes and one; false at the end.
bool next_line(std::istream& in, std::string& text) {
  text.clear();
  bool any = false;
  for (char c = 0; in.get(c); any = true) {
    if (c == '\n') return true;
    if (text.size() <= longest_line) text += c;
  }
  return any;
}

/// Adds the answer of a case to `answer`.
ExitCode solve_line(const input::CaseFile& input, const BatchRequest& request, Json& answer) {
  std::vector<Blow> blows = solve_blows(input.impact, input.options);
  Solution& solution = blows.back().solution;
  if (!request.no_intervals) uncertainty::add_intervals(input.impact, input.options, solution);
  const std::vector<output::BlowResult> series =
      output::blow_results(input.impact.blows ? std::span<const Blow>(blows) : std::span<const Blow>{});
  answer.update(Json::parse(
      output::result_json(input.impact, solution.summary, injury::whole_pulse_figures(solution), series)));
  return exit_code(solution.summary);
}

/// Answers a line; absent if nobody reads the answers any more.
std::optional<ExitCode> answer_line(const std::string& text, int line, const BatchRequest& request,
                                    std::optional<double> tolerance) {
  const bool is_stream = request.file == "-";
  input::JsonCase given{"", input::fault_of_file(request.file, "a line must not be longer than 1 MiB", line)};
  if (text.size() <= longest_line)
    given = input::read_case_json(
        text, line, request.file,
        is_stream ? std::filesystem::path() : std::filesystem::path(request.file).parent_path(),
        chosen_folder(request.materials));
  Json answer{{"id", given.id.empty() ? Json(nullptr) : Json::parse(given.id)}, {"line", line}};
  ExitCode code = exit_refused;
  if (given.read) {
    if (tolerance) given.read->options.tolerance = *tolerance;
    code = solve_line(*given.read, request, answer);
  } else {
    answer["faults"] = array_of(given.read.faults(), fault_json);
  }
  const int problem =
      write_all(STDOUT_FILENO, answer.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n");
  if (problem == EPIPE) return std::nullopt;
  if (problem != 0)
    throw std::runtime_error("could not write to standard output: " +
                             std::generic_category().message(problem));
  return code;
}

int batch(const BatchRequest& request) {
  std::vector<std::string> errors;
  const std::optional<double> tolerance = tolerance_of(request.tolerance, errors);
  std::ifstream file;
  if (request.file != "-") {
    file.open(std::filesystem::path(request.file));
    if (!file || std::filesystem::is_directory(request.file))
      errors.push_back(request.file + ": does not exist or cannot be read");
  }
  if (!errors.empty()) throw Refused(std::move(errors));
  std::istream& lines = request.file == "-" ? std::cin : file;
  ExitCode worst = exit_done;
  int number = 0;
  for (std::string text; next_line(lines, text);) {
    ++number;
    if (text.find_first_not_of(" \t\r") == std::string::npos) continue;
    const std::optional<ExitCode> code = answer_line(text, number, request, tolerance);
    if (!code) break;
    if (*code == exit_refused || worst == exit_done) worst = *code;
  }
  return worst;
}

}  // namespace

void add_batch(CLI::App& app, Action& action) {
  const auto [sub, request] = add_subcommand<BatchRequest>(
      app, action, "batch", "Solve cases given as lines of JSON, one after the other", batch_footer, batch);
  add_option(sub, "FILE", request.file, "File of JSON lines (- for standard input)")->required();
  add_tolerance(sub, request.tolerance);
  add_no_intervals(sub, request.no_intervals);
  add_material_folder(sub, request.materials);
}

}  // namespace dashpad::app
