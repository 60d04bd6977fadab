#pragma once
/// What the texts for other programs have in common, and the curves of a card as points.

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "dashpad/output/deck/exports.hpp"
#include "dashpad/output/material_deck.hpp"
#include "input/material_deck/deck_cards.hpp"

namespace dashpad::output {

/// Printable ASCII in one line: line breaks and other control characters become blanks, any other character
/// that is not ASCII becomes one "?". So does "&", with which LS-DYNA calls a parameter.
std::string plain_ascii(std::string_view text);

/// `text` as comments: folded at blanks, or where a word is too long within it, to lines of at most `width`
/// columns that each begin with `mark` and a blank.
std::string comment(std::string_view mark, std::string_view text, std::size_t width = 80);

/// Version, case, units, signs and flags, a line of text each.
std::vector<std::string> heading(const CurveFile& file);

/// The number in scientific notation with 14 significant digits (13 if negative), right-aligned in 20 columns
/// of which the first is blank.
std::string number_field(double value);

/// Two fields and the end of the line for each point.
std::string number_rows(const Curve& curve);

/// The curve with the numbers of the file's units, which the axes name in the place of SI units. Throws
/// std::invalid_argument if it breaks the rules of exports.hpp.
Curve in_units_of(const CurveFile& file, const Curve& curve);

/// *DEFINE_CURVE of LS-DYNA: fields of 10 columns, then `points` of 20 below the comment `axes`. SIDR 0: for
/// the transient analysis; scales 1, offsets 0; DATTYP 0: a curve over time, or of force over displacement.
std::string define_curve(const std::string& title, int id, std::string_view axes, const std::string& points);

/// "force (kN) over time (ms)", of a curve with its units as above.
std::string caption(const Curve& curve);

/// The number of the first curve. Throws std::invalid_argument if one of the file's numbers is out of range.
int checked_first_id(const CurveFile& file);

/// A curve of the deck, in SI; the origin is not among its points.
struct PointsAtRate {
  double rate = 0;
  TableCurve curve;
};

struct MaterialPoints {
  std::vector<PointsAtRate> loading;  ///< by rate
  std::optional<TableCurve> unloading;
  bool linear_in_rate = true;        ///< how the card goes from one rate to the next
  std::vector<std::string> remarks;  ///< what became points that was a formula
};

/// Formulas become points; without `with_rates` only the slowest curve is taken.
MaterialPoints material_points(const PadLaw& law, bool with_rates);

/// Steepest straight line between two points of any curve, Pa, rounded up.
double steepest_line(const MaterialPoints& points);

/// Writes numbers and counts those that their columns do not hold exactly.
class DeckNumbers {
 public:
  explicit DeckNumbers(const UnitSystem& units) : units_(units) {}

  /// Right-aligned.
  std::string field(input::Content content, double value, std::size_t width = 20);
  /// Strain and stress of a point, and the end of its line.
  std::string point(double strain, double stress);
  [[nodiscard]] std::size_t rounded() const { return rounded_; }

 private:
  input::DeckUnits units_;
  std::size_t rounded_ = 0;
};

/// The numbers of a card by the names of its fields, SI; 0 for those that it does not have.
using CardValues = std::map<std::string_view, double>;

/// A comment with the names of the fields, and below it their numbers. `width`: of all fields, in place of
/// their own.
std::string card_text(char mark, input::DeckCard card, const CardValues& values, DeckNumbers& numbers,
                      std::size_t width = 0);
/// The line of numbers alone.
std::string card_line(input::DeckCard card, const CardValues& values, DeckNumbers& numbers,
                      std::size_t width = 0);

/// What is written instead of 0, which solvers take for "not given".
double written_unloading_factor(const Foam& foam);

/// The body of the deck, without the comments at its beginning.
std::string ls_dyna_material(const Material& material, const MaterialPoints& points,
                             const MaterialDeckOptions& options, DeckNumbers& numbers);
std::string radioss_material(const Material& material, const MaterialPoints& points,
                             const MaterialDeckOptions& options, DeckNumbers& numbers);

/// The title of a card in one line that is neither a comment nor a keyword.
std::string deck_title(const Material& material, std::size_t width);

}  // namespace dashpad::output
