// dashpad study summary: the results of a store.

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <string>

#include <fmt/format.h>

#include "command.hpp"
#include "dashpad/impact/solution.hpp"
#include "dashpad/output/study.hpp"
#include "dashpad/quantities/quantity.hpp"
#include "dashpad/study/responses.hpp"
#include "dashpad/study/study_file.hpp"
#include "input/measurement/measurement_text.hpp"
#include "input/option_values.hpp"
#include "input/spelling.hpp"
#include "output_files.hpp"
#include "quantities/magnitude_bounds.hpp"
#include "study/study.hpp"

namespace dashpad::app {

namespace {

/// The response of that name; null if the store has none.
const study::StoredColumn* response_of(const std::string& name, const study::Store& store) {
  const auto found = std::ranges::find(store.responses(), name, &study::StoredColumn::name);
  return found == store.responses().end() ? nullptr : &*found;
}

constexpr const char* study_summary_footer = R"(Examples:
  dashpad study examples/studies/cushion-curves.toml --out cushions.db
  dashpad study summary cushions.db
  dashpad study summary cushions.db --response peak_acceleration --limit "peak_acceleration > 80 g"
  dashpad study summary cushions.db --standard en-1078
  dashpad study summary cushions.db --report cushions.html --picture cushions.svg
  dashpad study summary cushions.db --json - | jq .cushion_curves

Gives means, quantiles and the probability of exceeding a limit, or, with several limits or those of a --standard, any of
them, all with 95 % intervals; Sobol' indices if the
study has indices = true; cushion curves if it varies mass, speed and thickness. Combinations of levels are kept
separate. Rows in which the pad bottomed out on a rigid support are treated as exceeding every limit on force,
clips and HIC. The summary of an interrupted study covers the rows computed so far. docs/studies.md explains how
far to trust the results.

Exit codes: 0 success, 1 a result could not be written, 2 invalid input.)";

struct StudySummaryRequest {
  std::string store_file;
  std::vector<std::string> responses;
  std::vector<std::string> limits;
  std::vector<std::string> standards;
  std::string standard_folder;
  OutputFiles files;
};

/// Why the store has no such response; empty if it has.
std::string response_rule(const std::string& name, const study::Store& store) {
  if (response_of(name, store) != nullptr) return "";
  std::vector<std::string> names;
  for (const study::StoredColumn& response : store.responses()) names.push_back(response.name);
  return "is not a response of this study; available: " + input::listing(names);
}

/// A limit such as "hic15 > 1000" or "peak_force = 5 kN"; absent after an error.
std::optional<study::StudyLimit> limit_of(const std::string& text, const study::Store& store,
                                          std::vector<std::string>& errors) {
  const auto refuse = [&](const std::string& rule) {
    errors.push_back(fmt::format("--limit \"{}\": {}", text, rule));
    return std::nullopt;
  };
  const std::size_t sign = text.find_first_of(">=");
  if (sign == std::string::npos)
    return refuse("must consist of a response, > and a value, as in \"hic15 > 1000\"");
  const std::string name = std::string(input::without_blanks(text.substr(0, sign)));
  if (const std::string rule = response_rule(name, store); !rule.empty()) return refuse(name + " " + rule);
  const std::string value = text.substr(sign + 1);
  const std::string& unit = response_of(name, store)->unit;
  try {
    return study::StudyLimit{
        name, stated_si(input::with_gravity(std::string(input::without_blanks(value)), unit), unit)};
  } catch (const UnitError& error) {
    return refuse(error.what());
  }
}

study::StudyQuestions questions_of(const StudySummaryRequest& request, const study::Store& store,
                                   std::vector<std::string>& errors) {
  study::StudyQuestions questions;
  for (const std::string& name : request.responses) {
    if (const std::string rule = response_rule(name, store); !rule.empty())
      errors.push_back(fmt::format("--response {}: {}", name, rule));
    else if (std::ranges::find(questions.responses, name) == questions.responses.end())
      questions.responses.push_back(name);
  }
  for (const std::string& text : request.limits)
    if (const std::optional<study::StudyLimit> limit = limit_of(text, store, errors))
      questions.limits.push_back(*limit);
  return questions;
}

/// Adds the limits of a standard, which the study must keep, and what is to be said about them.
void add_standard(const std::string& name, const std::string& folder, const study::Store& store,
                  study::StudyQuestions& questions, std::vector<std::string>& errors) {
  std::vector<input::InputFile> files;
  const auto standard = standard_of(name, chosen_standards(folder), files, errors);
  if (!standard) return;
  for (const injury::Criterion& criterion : standard->criteria) {
    const std::string key = criterion.quantity->key;
    if (response_of(key, store) == nullptr)
      errors.push_back(fmt::format(
          "--standard {}: limits {}, which this study did not keep; add it to the responses", name, key));
    else
      questions.limits.push_back({key, criterion.limit});
  }
  for (Flag& flag : injury::reservations_about_limits(*standard))
    questions.reservations.push_back(std::move(flag));
  const Impactor own = study::stored_study(store).base.impactor;
  const auto differs = [](const injury::StandardValue& value, double used) {
    return value.value && injury::differ(*value.value, used);
  };
  if (differs(standard->mass, own.mass) || differs(standard->speed, own.speed))
    questions.reservations.push_back(
        flag_of("REPLACED", fmt::format("the study's case does not have the mass or the speed of {}", name)));
}

/// Drawn before anything is written, since one row, or rows that all bottomed out, give no picture.
std::string picture_of(const OutputFiles& files, const study::StudyAnswers& answers) {
  const std::string& file = files.of("--picture");
  if (file.empty()) return {};
  try {
    return output::picture(output::study_plot(answers, unit_system(files.units)),
                           *output::picture_format(file));
  } catch (const std::invalid_argument&) {
    throw Refused({fmt::format(
        "--picture {}: there is nothing to draw; --report shows all figures of the study", file)});
  }
}

int summarise(const StudySummaryRequest& request) {
  const study::Store store = open_stored(request.store_file);
  std::vector<std::string> errors;
  judge_files(request.files, files_of_store(request.store_file), errors);
  judge_picture(request.files, errors);
  study::StudyQuestions questions = questions_of(request, store, errors);
  const bool asks_for_limits = !request.standards.empty() || !request.limits.empty();
  for (const std::string& name : asks_for_limits ? request.standards : study::stored_standards(store))
    add_standard(name, request.standard_folder, store, questions, errors);
  if (errors.empty() && store.rows_done() == 0)
    errors.push_back(request.store_file + ": has no rows yet; run dashpad study first");
  if (!errors.empty()) throw Refused(std::move(errors));

  const study::StudyAnswers answers = study::study_answers(store, questions);
  const std::string picture = picture_of(request.files, answers);
  const auto document = [&](output::Pictures pictures) {
    return output::study_document(answers, unit_system(request.files.units), pictures);
  };
  publish(request.files, document,
          {{"--json", [&](const Target&) { return output::study_json(answers); }},
           {"--picture", [&](const Target&) { return picture; }}});
  return exit_done;
}

}  // namespace

void add_study_summary(CLI::App& study, Action& action) {
  const auto [sub, request] = add_subcommand<StudySummaryRequest>(
      study, action, "summary", "Show distributions, probabilities, sensitivities and cushion curves",
      study_summary_footer, summarise);
  add_option(sub, "FILE", request.store_file, "The store of a study")->required();
  add_option(sub, "--response NAME", request.responses, "Only this response; may be repeated")->take_all();
  add_option(sub, "--limit LIMIT", request.limits,
             "Give the probability of exceeding this limit, \"hic15 > 1000\" or hic15=1000; may be repeated")
      ->take_all();
  add_option(sub, "--standard NAME[:VARIANT]", request.standards,
             "Give the probability of exceeding the limits of this standard; may be repeated")
      ->take_all();
  add_standard_folder(sub, request.standard_folder);
  add_documents(sub, request.files);
  add_file(sub, request.files, "--json",
           "Write all results as JSON, in SI units and g (- for standard output)");
  add_file(sub, request.files, "--picture", "Draw the most informative figure (.svg, .png, .pdf)");
  add_units(sub, request.files.units);
  add_force(sub, request.files.force);
}

}  // namespace dashpad::app
