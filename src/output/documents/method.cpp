#include "output/documents/method.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <variant>

#include <fmt/format.h>

#include "dashpad/model/pad/law.hpp"

namespace dashpad::output {

namespace {

constexpr std::string_view crash_padding = "crash-padding-1986";
constexpr std::string_view regulation = "49-cfr-571-208";

// Each also stands in theory.md, section 9, and the program in CITATION.cff; a test compares them.
constexpr std::array known_publications{
    Publication{.key = crash_padding,
                .type = "report",
                .authors = "Transportation Systems Center",
                .title = "Crash Padding Research. Volume III: Impact Analysis and Model Validation",
                .publisher = "U.S. Department of Transportation",
                .place = "Cambridge, Massachusetts",
                .year = 1986,
                .month = 7},
    Publication{.key = "avalle-2007",
                .type = "article-journal",
                .authors = "Avalle, M.; Belingardi, G.; Ibba, A.",
                .title = "Mechanical models of cellular solids",
                .container = "International Journal of Impact Engineering",
                .volume = "34",
                .pages = "3-27",
                .year = 2007},
    Publication{.key = "gibson-ashby-1997",
                .type = "book",
                .authors = "Gibson, L. J.; Ashby, M. F.",
                .title = "Cellular Solids",
                .edition = "2",
                .place = "Cambridge",
                .year = 1997},
    Publication{.key = "nagy-1974",
                .type = "article-journal",
                .authors = "Nagy; Ko; Lindholm",
                .title = {},
                .container = "Journal of Cellular Plastics",
                .volume = "10",
                .year = 1974},
    Publication{.key = regulation,
                .type = "legislation",
                .authors = {},
                .title = "49 CFR 571.208",
                .read_at = "law.cornell.edu"},
    Publication{.key = this_program,
                .type = "software",
                .authors = "The Dashpad authors",
                .title = "Dashpad: impact of a rigid nose on a foam pad",
                .year = 2026,
                .month = 11},
};

/// The uses in the order of the publications, each named once.
class Uses {
 public:
  Uses() {
    for (const Publication& each : known_publications) uses_.push_back({&each, {}, {}});
  }
  void add(std::string_view key, const std::string& what, const char* where = nullptr) {
    Use& use = uses_[static_cast<std::size_t>(&publication(key) - known_publications.data())];
    add_once(use.what, what);
    if (where != nullptr) add_once(use.where, where);
  }
  /// A part of Dashpad's own, by its section of theory.md.
  void add_own(bool is_used, const char* what, const char* section) {
    if (is_used) add(this_program, what, section);
  }
  std::vector<Use> taken() && {
    std::erase_if(uses_, [](const Use& use) { return use.what.empty(); });
    return std::move(uses_);
  }

 private:
  static void add_once(std::vector<std::string>& words, const std::string& word) {
    if (std::ranges::count(words, word) == 0) words.push_back(word);
  }
  std::vector<Use> uses_;
};

void add_curves(Uses& uses, const FoamCurves& curves) {
  if (std::holds_alternative<AvalleCurve>(curves.base)) uses.add("avalle-2007", "base curve of the foam");
  if (std::holds_alternative<GibsonAshbyCurve>(curves.base))
    uses.add("gibson-ashby-1997", "base curve of the foam", "section 5.3");
  if (std::holds_alternative<PowerCurve>(curves.base))
    uses.add(crash_padding, "base curve of the foam, shaped as law 4", "Appendix B");
  if (std::holds_alternative<PowerRateEffect>(curves.rate_effect))
    uses.add("nagy-1974", "rate effect of the foam");
}

void add_law(Uses& uses, const PadLaw& law) {
  const std::string what = fmt::format("{} law", name_of(law));
  const FoamCurves* const curves = foam_curves(law);
  if (curves != nullptr || std::holds_alternative<ViscoelasticFoam>(law))
    uses.add(this_program, what, "5.1");
  else
    uses.add(crash_padding, what, "Appendix B: subroutine PAD by D. Y. Jeong and O. Orringer");
  if (curves != nullptr) add_curves(uses, *curves);
}

}  // namespace

std::span<const Publication> publications() { return known_publications; }

const Publication& publication(std::string_view key) {
  for (const Publication& each : known_publications)
    if (each.key == key) return each;
  throw std::invalid_argument(fmt::format("no publication \"{}\"", key));
}

std::vector<Use> method_of(const ImpactCase& impact, Computed computed) {
  const Pad& pad = impact.pad;
  Uses uses;
  uses.add(crash_padding, "independent columns of foam below a rigid nose", "sections 2.1 to 2.3");
  if (computed.hic) uses.add(regulation, "HIC15 and HIC36");
  // Dashpad's own parts by section, as they are listed.
  uses.add_own(!std::holds_alternative<Sphere>(impact.impactor.nose), "nose other than a sphere", "1");
  uses.add_own(true, "steps, events and numerical errors", "4");
  if (pad.layers.empty()) add_law(uses, pad.material.law);
  for (const PadLayer& layer : pad.layers) add_law(uses, layer.material.law);
  uses.add_own(impact.backing != Backing(), "parts of the support", "5.2");
  uses.add_own(impact.blows || pad.earlier_penetration > 0, "repeated blows", "5.3");
  uses.add_own(!pad.layers.empty(), "layers", "5.4");
  uses.add_own(pad.sheet > 0, "sheet on the pad", "5.5");
  uses.add_own(pad.neighbours > 0, "effect of neighbouring columns", "6.1");
  uses.add_own(computed.intervals, "uncertainty intervals", "6.2");
  return std::move(uses).taken();
}

std::string places_of(const Use& use) {
  if (use.where.empty()) return "";
  if (use.publication->key != this_program) return fmt::format("{}", fmt::join(use.where, "; "));
  std::string places = "docs/theory.md, section";
  if (use.where.size() > 1) places += 's';
  for (std::size_t i = 0; i < use.where.size(); ++i)
    places += (i == 0 ? " " : i + 1 < use.where.size() ? ", " : " and ") + use.where[i];
  return places;
}

std::string source_of(const Use& use) {
  const Publication& from = *use.publication;
  const std::string places = places_of(use);
  if (from.key == this_program) return places;
  std::string text = from.authors.empty() ? "" : fmt::format("{}: ", from.authors);
  text += from.title.empty() ? fmt::format("{} {}", from.container, from.volume) : std::string(from.title);
  if (from.year > 0) text += fmt::format(", {}", from.year);
  return places.empty() ? text : fmt::format("{}; {}", text, places);
}

}  // namespace dashpad::output
