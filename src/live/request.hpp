#pragma once
/// What requests have in common: their values, the case and the standard that they name, and faults as an
/// answer.

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "dashpad/impact/solve.hpp"
#include "dashpad/injury/standard.hpp"
#include "dashpad/input/case_file.hpp"
#include "dashpad/margin/margin.hpp"
#include "dashpad/output/document.hpp"
#include "dashpad/quantities/unit_system.hpp"
#include "json/json_values.hpp"
#include "live/answer.hpp"

namespace dashpad::live {

/// What a live page shows of a case has no name of a file.
inline constexpr const char* name_of_case = "the case";

std::string text_of(const Json& request, const char* key);
bool is_set(const Json& request, const char* key);
std::optional<double> number_of(const Json& request, const char* key);
std::vector<std::string> texts_of(const Json& request, const char* key);
/// A number in SI, or a text with its unit as an option of the command, more than 0; else a fault that names
/// the option.
std::optional<double> value_of(const Json& request, const char* key, const char* option, const char* unit,
                               std::vector<input::Fault>& faults);
const UnitSystem& units_of(const Json& request);

/// Those that the request names in place of what came with the engine.
Folders folders_of(const Json& request, const Folders& own);

void add(const std::vector<input::Fault>& more, std::vector<input::Fault>& faults);
/// {"faults": [...], "lines": as the command shows them}.
Json faults_json(const std::vector<input::Fault>& faults);
Json fault_json(const std::string& key, const std::string& rule);

input::Reading<input::CaseFile> read_case(const Json& request, const Folders& folders);
/// The standard with its variants; absent without one.
input::Reading<std::optional<injury::Standard>> read_standard(const Json& request, const Folders& folders);

/// The file of the standard, among those that must not be overwritten.
std::optional<input::InputFile> standard_file(const Json& request, const Folders& folders);

/// A case that is to be solved.
struct Asked {
  std::string name;  ///< as faults call the case
  input::CaseFile given = {};
  ImpactCase impact = {};  ///< with the impactor of the standard
  injury::Kept kept = {};
  std::vector<margin::Limit> limits = {};         ///< of the user
  std::optional<injury::Standard> own = {};       ///< with its own nose and speed, and the values of the user
  std::optional<injury::Standard> standard = {};  ///< with those of the case, if they are kept
};
/// All faults of standard and case.
input::Reading<Asked> read_asked(const Json& request, const Folders& folders);
/// The blows of a case, or the only one of a standard; with "intervals" of the last.
std::vector<Blow> solved_blows(const Json& request, const Asked& asked, const Options& options);

/// The choices of nose and speed that would have changed the verdict; each is a reservation of the
/// assessment, too.
std::vector<injury::OtherChoice> other_choices(const Json& request, const Asked& asked,
                                               injury::Assessment& assessment);

/// "key" of the case, which is to keep the limits of the standard and of the user.
input::Reading<margin::Question> read_question(const Json& request, const Folders& folders);

/// "title", "tone" and "html" of a document that has a lead.
void add_page(Json& answer, output::Document document, const UnitSystem& units);

/// Names and titles of all cards and standards, in the order of the names.
Json list_all(const Folders& folders);

/// The text of the answer that `answer_to` gives to the text of a request.
std::string answered(std::string_view request, const std::function<Json(const Json&)>& answer_to);

}  // namespace dashpad::live
