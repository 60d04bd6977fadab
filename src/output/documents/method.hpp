#pragma once
/// The publications whose formulas Dashpad computes with, and what a case takes from each of them.

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "dashpad/impact/impact_case.hpp"

namespace dashpad::output {

/// As the documents state it (theory.md, section 9): what they do not state is empty, or 0.
struct Publication {
  std::string_view key;
  std::string_view type;     ///< of CSL: "report", "article-journal", "book", "legislation", "software"
  std::string_view authors;  ///< "Avalle, M.; Ibba, A.", or an institution, without a comma
  std::string_view title;
  std::string_view container = {};  ///< the journal
  std::string_view volume = {}, pages = {}, edition = {}, publisher = {}, place = {};
  int year = 0, month = 0;
  std::string_view read_at = {};  ///< where the text was read
};

inline constexpr std::string_view this_program = "dashpad";

std::span<const Publication> publications();
/// The publication with that key, which must be there.
const Publication& publication(std::string_view key);

/// What a result takes from a publication, and where it stands there; of Dashpad itself, in which section of
/// docs/theory.md.
struct Use {
  const Publication* publication;
  std::vector<std::string> what, where;
};

/// Figures that not every result has.
struct Computed {
  bool hic = true;
  bool intervals = true;
};

/// Everything that a result of this case takes from publications, Dashpad last.
std::vector<Use> method_of(const ImpactCase& impact, Computed computed = {});

/// "docs/theory.md, sections 4 and 5.1" of Dashpad itself; empty if nothing more is known than the text.
std::string places_of(const Use& use);
/// The publication in short with those places; of Dashpad itself the places alone.
std::string source_of(const Use& use);

}  // namespace dashpad::output
