#pragma once
/// The curves of a card as points, and the texts that decks make of a material.

#include <optional>
#include <string>
#include <vector>

#include "dashpad/output/material_deck.hpp"
#include "input/material_deck/deck_unit.hpp"

namespace dashpad::output {

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

  std::string plain(double value, std::size_t width) { return field(value, units_.none, width); }
  std::string stress(double value, std::size_t width) { return field(value, units_.stress, width); }
  std::string density(double value, std::size_t width) { return field(value, units_.density, width); }
  std::string rate(double value, std::size_t width) { return field(value, units_.rate, width); }
  std::string time(double value, std::size_t width) { return field(value, units_.time, width); }
  [[nodiscard]] std::size_t rounded() const { return rounded_; }

 private:
  /// Right-aligned.
  std::string field(double value, const input::DeckUnit& unit, std::size_t width);

  input::DeckUnits units_;
  std::size_t rounded_ = 0;
};

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
