#pragma once
/// Text shared by all decks, and the curves of a card as points.

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "dashpad/output/deck/exports.hpp"
#include "dashpad/output/material_deck.hpp"
#include "input/material_deck/deck_cards.hpp"

namespace dashpad::output {

/// Printable ASCII in one line: control characters become blanks; other characters that are not ASCII, and
/// "&", which marks a parameter in LS-DYNA, become "?".
std::string plain_ascii(std::string_view text);

/// `text` as comment lines of at most `width` columns that each begin with `mark` and a blank, folded at
/// blanks or within words that are too long.
std::string comment(std::string_view mark, std::string_view text, std::size_t width = 80);

/// Lines with version, case, units, signs and flags.
std::vector<std::string> heading(const CurveFile& file);

/// The number in scientific notation with 14 significant digits (13 if negative), right-aligned in 20
/// columns, the first of which is blank.
std::string number_field(double value);

/// A line of two fields for each point.
std::string number_rows(const Curve& curve);

/// The curve in the units of the file, which also replace those of the axes. Throws std::invalid_argument if
/// it breaks the rules of exports.hpp.
Curve in_units_of(const CurveFile& file, const Curve& curve);

/// *DEFINE_CURVE of LS-DYNA: fields of 10 columns, then `points` of 20 below the comment `axes`. SIDR 0: for
/// the transient analysis; scales 1, offsets 0; DATTYP 0: over time, or force over displacement.
std::string define_curve(const std::string& title, int id, std::string_view axes, const std::string& points);

/// "force (kN) against time (ms)", for a curve in units of the file.
std::string caption(const Curve& curve);

/// The number of the first curve. Throws std::invalid_argument if a number of the file is out of range.
int checked_first_id(const CurveFile& file);

/// A curve of the deck, SI, without the origin.
struct PointsAtRate {
  double rate = 0;
  TableCurve curve;
};

struct MaterialPoints {
  std::vector<PointsAtRate> loading;  ///< by rate
  std::optional<TableCurve> unloading;
  bool linear_in_rate = true;        ///< interpolation between rates
  std::vector<std::string> remarks;  ///< formulas that became points
};

/// The curves of a law, with formulas as points. Without `with_rates` only the slowest curve.
MaterialPoints material_points(const PadLaw& law, bool with_rates);

/// The same with each curve as evenly placed points of the law itself, as the options say.
MaterialPoints placed_points(const PadLaw& law, bool with_rates, const MaterialDeckOptions& options);

/// The unloading of a foam from a strain, at the slowest rate, as points of the law.
TableCurve unloading_points(const Foam& foam, double from);

/// The curves of a deck, as its format and options want them. The deck must be possible.
MaterialPoints deck_points(const Material& material, const MaterialDeckOptions& options);

/// The steepest straight line between two points of any curve, Pa, rounded up.
double steepest_line(const MaterialPoints& points);

/// Writes numbers, and counts those that do not fit exactly.
class DeckNumbers {
 public:
  explicit DeckNumbers(const UnitSystem& units) : units_(units) {}

  std::string field(input::Content content, double value, std::size_t width = 20);
  /// Strain and stress of a point, and a line break.
  std::string point(double strain, double stress) {
    return field(input::Content::number, strain) + field(input::Content::stress, stress) + "\n";
  }
  [[nodiscard]] std::size_t rounded() const { return rounded_; }

 private:
  input::DeckUnits units_;
  std::size_t rounded_ = 0;
};

/// The numbers of a card by field name, SI; missing ones are 0.
using CardValues = std::map<std::string_view, double>;

/// A comment with the names of the fields, and a line with their numbers. `width` overrides theirs.
std::string card_text(char mark, input::DeckCard card, const CardValues& values, DeckNumbers& numbers,
                      std::size_t width = 0);
/// The line of numbers alone.
std::string card_line(input::DeckCard card, const CardValues& values, DeckNumbers& numbers,
                      std::size_t width = 0);

/// The unloading factor as written: solvers take 0 for "not given".
double written_unloading_factor(const Foam& foam);

/// The deck without its leading comments.
std::string ls_dyna_material(const Material& material, const MaterialPoints& points,
                             const MaterialDeckOptions& options, DeckNumbers& numbers);
std::string radioss_material(const Material& material, const MaterialPoints& points,
                             const MaterialDeckOptions& options, DeckNumbers& numbers);

/// A name that Abaqus takes without quotes: letters, digits, _ and -, a letter first, at most 80.
std::string abaqus_name(const Material& material);
/// Of a foam.
std::string abaqus_material(const Material& material, const MaterialPoints& points,
                            const MaterialDeckOptions& options, DeckNumbers& numbers);

/// The title of a card as one line that is neither a comment nor a keyword.
std::string deck_title(const Material& material, std::size_t width);

}  // namespace dashpad::output
