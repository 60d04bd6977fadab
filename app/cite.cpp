// dashpad cite: the sources that a result of a case rests on.

#include <string>
#include <vector>

#include "command.hpp"
#include "dashpad/input/case_file.hpp"
#include "dashpad/output/citation.hpp"
#include "output.hpp"

namespace dashpad::app {

namespace {

constexpr const char* cite_footer = R"(Examples:
  dashpad cite examples/helmet-pad-10fps.toml                          a list for a report
  dashpad cite examples/helmet-pad-10fps.toml --standard en-1078       with the sources of its limits
  dashpad cite examples/dashboard-20mph.toml --format bibtex > sources.bib
  dashpad cite examples/dashboard-20mph.toml --format csl-json > sources.json   for reference managers
  dashpad cite examples/dashboard-20mph.toml --json | jq -r '.sources[].title'

Lists what a result of the case rests on, and nothing that it does not use: each foam with what was measured and
the source that its card states, each standard with the source of every value, the publications of the method with
what is taken from them, and Dashpad with its version and commit. What was assumed, reconstructed or not verified
stands below each source. The case is read, but not solved.

Nothing is added to what cards, standards and documents state: a year that they do not state is left out. A foam whose
law is typed in the case has no source, and the list says so. BibTeX and CSL-JSON have the words of the card or the
standard, and the remarks, in the field "note".

Exit codes: 0 success, 2 the case or a standard cannot be read.)";

struct CiteRequest {
  GivenCase given;
  std::vector<std::string> standards;
  std::string standard_folder;
  std::string format = "text";
  bool as_json = false;
};

int cite(const CiteRequest& request) {
  std::vector<std::string> errors;
  if (request.as_json && request.format != "text")
    errors.push_back("--json: give either --json or --format " + request.format + ", not both");
  std::optional<input::CaseFile> input = read_case(request.given, errors);
  std::vector<input::InputFile> files;
  std::vector<injury::Standard> standards;
  const std::filesystem::path folder = chosen_standards(request.standard_folder);
  for (const std::string& name : request.standards)
    if (auto standard = standard_of(name, folder, files, errors)) standards.push_back(*std::move(standard));
  if (!errors.empty()) throw Refused(std::move(errors));
  // The nose of a standard takes the place of the case's.
  if (!standards.empty()) input->impact = injury::with_impactor_of(standards.front(), input->impact);
  const std::vector<output::Citation> citations = output::citations_of(input->impact, standards);
  if (request.as_json)
    write_result(output::citations_json(request.given.file, citations));
  else if (request.format == "bibtex")
    write_result(output::citations_bibtex(citations));
  else if (request.format == "csl-json")
    write_result(output::citations_csl_json(citations));
  else
    write_output(output::citations_text(request.given.file, citations));
  return exit_done;
}

}  // namespace

void add_cite(CLI::App& app, Action& action) {
  const auto [sub, request] = add_subcommand<CiteRequest>(
      app, action, "cite", "List the sources that a result rests on, for a report or a reference manager",
      cite_footer, cite);
  add_case(sub, request.given);
  add_option(sub, "--standard NAME", request.standards,
             "Standard by which the case is assessed, with variants as in fmvss-218:small; may be repeated");
  add_option(sub, "--format FORMAT", request.format, "text (default), bibtex or csl-json")
      ->check(CLI::IsMember({"text", "bibtex", "csl-json"}));
  add_flag(sub, "--json", request.as_json, "Print everything that is known of the sources as JSON");
  add_material_folder(sub, request.given.materials);
  add_standard_folder(sub, request.standard_folder);
}

}  // namespace dashpad::app
