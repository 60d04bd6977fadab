#pragma once
/// The output of an impact, or of the last of several blows: documents and pictures, JSON and CSV.

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
/// penetration, with the flags in the small print.
Plot result_plot(const ImpactCase& impact, const Solution& solution,
                 const std::optional<injury::InjuryFigures>& injury, const UnitSystem& units);

/// A drawing to scale of nose, pad and support at first contact and at greatest penetration, as a complete
/// `<svg>` element without scripts and references. Columns are shaded by their strain; the penetration, what
/// is left of the pad and the deflection of its support are dimensions in `units`. Parts of the support are
/// symbols.
///
/// `solution` is the one of solve() for `impact`, also for a blow of a series. For a case that breaks a rule
/// (violations()) the drawing says so.
std::string impact_drawing(const ImpactCase& impact, const Solution& solution, const UnitSystem& units);

/// The drawing as a picture file for light paper. Throws std::runtime_error if it cannot be made.
std::string impact_drawing(const ImpactCase& impact, const Solution& solution, const UnitSystem& units,
                           PictureFormat format);

/// The text of the drawing's `<style>`, always the same, for policies that admit styles by their hashes.
std::string_view impact_drawing_style();

/// The case as `dashpad run --json` echoes it, with its options, in SI.
std::string case_json(const ImpactCase& impact, const Options& options);

/// The result as JSON (schema/summary.schema.json): the summary, its case and the program, in SI units, which
/// the keys name. Numbers read back exactly; figures that are absent or not finite are null, and so is
/// "injury" without `injury`. `blows` are those of a series, the last of which is the summary.
std::string result_json(const ImpactCase& impact, const Summary& summary,
                        const std::optional<injury::InjuryFigures>& injury = std::nullopt,
                        const std::vector<BlowResult>& blows = {});

/// The history as CSV with a header and a row for each time step. Columns: time, force, acceleration (in g),
/// velocity, motion, penetration, support_deflection, contact_radius, axis_strain, those of a moving support
/// and of layers; the header has the units. Signs are those of History. In plain SI numbers read back
/// exactly, except those in g; values that are not finite are empty. RFC 4180, with LF as line end.
std::string history_csv(const History& history, const UnitSystem& units);

/// The motion of two bodies after an impact and where its energy went. `impact` is the solved case of the
/// relative motion, with the reduced mass M1 M2 / (M1 + M2) and the speed of approach V1 - V2.
Document post_impact_document(const Body& first, const Body& second, const ImpactCase& impact,
                              const Solution& solution, const UnitSystem& units);
std::string post_impact_json(const Body& first, const Body& second, const ImpactCase& impact,
                             const Solution& solution);

}  // namespace dashpad::output
