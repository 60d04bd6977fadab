#pragma once
/// The sources that a result rests on, for those who cite it: foams, standards, method and program.

#include <span>
#include <string>
#include <vector>

#include "dashpad/impact/impact_case.hpp"
#include "dashpad/injury/standard.hpp"

namespace dashpad::output {

enum class Cited { foam, standard, method, program };
/// "foam", "standard", "method", "program".
std::string to_string(Cited cited);

/// A source as cards, standards and documents state it; what they do not state is empty, or 0.
struct Citation {
  Cited cited = Cited::method;
  std::string key = {};                   ///< unique in a list: letters, digits and hyphens
  std::string type = {};                  ///< of CSL: "dataset", "standard", "report", "software", ...
  std::vector<std::string> authors = {};  ///< "Avalle, M.", or an institution, without a comma
  std::string title = {};
  std::string container = {}, volume = {}, pages = {}, edition = {};
  std::string publisher = {}, place = {};
  std::string number = {};   ///< of a standard: the text that is binding
  std::string version = {};  ///< of a program
  int year = 0, month = 0;
  std::string source = {};                ///< in the words of the card or the standard; where a text was read
  std::vector<std::string> uses = {};     ///< what the result takes from it
  std::vector<std::string> remarks = {};  ///< what is assumed, reconstructed or not verified
};

/// The sources of a case as it is solved, with the impactor of a standard if it is assessed; in the order of
/// Cited, each once.
std::vector<Citation> citations_of(const ImpactCase& impact, std::span<const injury::Standard> standards);

/// For a report: a list in words, below the name of the case.
std::string citations_text(const std::string& name, std::span<const Citation> citations);
/// BibTeX, an entry each.
std::string citations_bibtex(std::span<const Citation> citations);
/// CSL-JSON, as reference managers read it.
std::string citations_csl_json(std::span<const Citation> citations);
/// Everything above, with what the result takes from each.
std::string citations_json(const std::string& name, std::span<const Citation> citations);

}  // namespace dashpad::output
