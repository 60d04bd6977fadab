#pragma once
/// The output of one impact, or of the last of a series of blows: a document, a page, a still and a drawing
/// for people, JSON and CSV for programs.

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "dashpad/impact/contact_snapshot.hpp"
#include "dashpad/impact/impact_case.hpp"
#include "dashpad/impact/post_impact.hpp"
#include "dashpad/impact/solution.hpp"
#include "dashpad/impact/solve.hpp"
#include "dashpad/injury/figures.hpp"
#include "dashpad/output/document.hpp"
#include "dashpad/output/plot/plot.hpp"
#include "dashpad/quantities/unit_system.hpp"

namespace dashpad::output {

/// The results of one blow of a series.
struct BlowResult {
  Summary summary;
  std::optional<injury::InjuryFigures> injury;  ///< absent where the pulse is not whole
  double earlier_penetration = 0;               ///< penetration left by earlier blows, m
};
std::vector<BlowResult> blow_results(std::span<const Blow> blows);

struct ImpactReport {
  const ImpactCase& impact;
  const Options& options;
  const Solution& solution;
  std::optional<injury::InjuryFigures> injury = {};  ///< absent where the pulse is not whole
  std::vector<BlowResult> blows = {};           ///< the blows of a series, the last of which is the solution
  std::vector<ContactSnapshot> snapshots = {};  ///< for the page; may be empty
};

/// The answer, how it ended, what to beware of, the figures, and what they rest on.
Document impact_document(const ImpactReport& report, const UnitSystem& units,
                         Pictures pictures = Pictures::left_out);

/// The page. `shown` are the units at first; the reader may switch to the others.
std::string impact_page(const ImpactReport& report, const UnitSystem& shown);

/// A still: acceleration over time with the window of HIC15 and the 3 ms clip, and force over motion and
/// penetration; the flags of the result in the small print.
Plot result_plot(const ImpactCase& impact, const Solution& solution,
                 const std::optional<injury::InjuryFigures>& injury, const UnitSystem& units);

/// A drawing to scale: nose, pad and support at first contact and at greatest penetration. One complete
/// `<svg>` element, which is a file as it is and can stand in a page: it has no script and refers to nothing
/// outside itself. Columns are shaded by their strain; what is left of the pad, its penetration and the
/// deflection of its support are dimensions in `units`. Parts of the support are symbols.
///
/// `solution` is that of solve(), of a series that of the blow which `impact` is on its pad. A case that
/// breaks a rule (violations()) gives an element that says so.
std::string impact_drawing(const ImpactCase& impact, const Solution& solution, const UnitSystem& units);

/// The same as the bytes of a picture file; PNG and PDF are for light paper. Throws std::runtime_error if
/// they cannot be made.
std::string impact_drawing(const ImpactCase& impact, const Solution& solution, const UnitSystem& units,
                           PictureFormat format);

/// The text of the drawing's `<style>`, always the same: for a page whose policy admits styles by their
/// hashes.
std::string_view impact_drawing_style();

/// JSON text (RFC 8259, UTF-8, ends with a line break) that schema/summary.schema.json describes: the
/// summary, the case that it belongs to and the program that made it. SI units, which the keys name. Every
/// number reads back as the very same double; a figure that is absent or not finite is null.
/// `injury` is null in the JSON where there are no figures. `blows`: of a series, whose last blow the summary
/// is; null if there are none.
std::string result_json(const ImpactCase& impact, const Summary& summary,
                        const std::optional<injury::InjuryFigures>& injury = std::nullopt,
                        const std::vector<BlowResult>& blows = {});

/// CSV text: a header row, then a row a time step. Columns: time, force, acceleration (in g), velocity,
/// motion, penetration, support_deflection, contact_radius, axis_strain; the header adds the unit:
/// "time_s", "velocity_m_per_s". Signs are those of History. Numbers read back as the very same double (in
/// plain SI as the solver's own, but for g); one that is not finite is an empty field. RFC 4180 but for the
/// line ends, which are '\n'.
std::string history_csv(const History& history, const UnitSystem& units);

/// The motion of two bodies after an impact and where its energy went. `impact` is the case as solved: with
/// the reduced mass M1 M2 / (M1 + M2) and the speed of approach V1 - V2, with which the relative motion of
/// two free bodies is that of one body against a wall.
Document post_impact_document(const Body& first, const Body& second, const ImpactCase& impact,
                              const Solution& solution, const UnitSystem& units);
std::string post_impact_json(const Body& first, const Body& second, const ImpactCase& impact,
                             const Solution& solution);

}  // namespace dashpad::output
