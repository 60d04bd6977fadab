#pragma once
/// Material cards as decks of other solvers. docs/material-decks.md says what stands where.

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "dashpad/model/pad/material.hpp"
#include "dashpad/quantities/unit_system.hpp"

namespace dashpad::output {

/// A material of another solver.
struct MaterialDeckFormat {
  const char* name;      ///< as on the command line: "ls-dyna-083"
  const char* card;      ///< "*MAT_FU_CHANG_FOAM"
  std::string_view law;  ///< that it is for: "foam", "crushable-foam", "viscoelastic-foam"
  bool has_rates;
};
std::span<const MaterialDeckFormat> material_deck_formats();

struct MaterialDeckOptions {
  std::string format;
  UnitSystem units = consistent_systems().front();
  int first_id = 1;                  ///< of the material and of its curves
  std::optional<double> up_to = {};  ///< strain to which curves are continued as by the card, (0, 0.99]
  std::optional<double> rate = {};   ///< rate of the curve, 1/s, for formats with one curve
  std::optional<int> points = {};    ///< of each curve with its origin, 4 to 100 (100)
  /// Evenly spaced points of six digits in place of those of the card.
  [[nodiscard]] bool places_points() const { return up_to || rate || points; }
};
inline constexpr int min_deck_points = 4;    ///< of which one is the origin: a curve needs three others
inline constexpr int max_deck_points = 100;  ///< what LS-DYNA keeps of a curve by default (LCINT)
inline constexpr double highest_up_to = 0.99;

/// The reason why the deck cannot be written: a law for which the format has no card, no density, numbers
/// out of range, or an unknown format. Empty if it can.
std::string why_no_material_deck(const Material& material, const MaterialDeckOptions& options);

/// Sentences on what the deck leaves out or says otherwise, which it also has as comments.
std::vector<std::string> not_in_material_deck(const Material& material, const MaterialDeckOptions& options);

/// The material with its curves, ready to be included. A number that was read from such a deck is written
/// with the same value, as far as 20 columns hold its digits. Throws std::invalid_argument with
/// why_no_material_deck().
std::string material_deck(const Material& given, const MaterialDeckOptions& options);

/// A deck of LS-DYNA or Abaqus that includes that deck as the file `included` and compresses one element of
/// the material at the highest rate of its curves, with the force by the curve in straight lines, F = A s(v t
/// / L), as comments. Nobody ran it in that solver, which it says. For formats of these solvers.
std::string material_check_deck(const Material& material, const MaterialDeckOptions& options,
                                const std::string& included);

}  // namespace dashpad::output
