#pragma once
/// Decks as keywords with their lines, the fields in them, and the foams that they describe.

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "dashpad/input/material_deck.hpp"
#include "dashpad/model/pad/foam/table_curve.hpp"
#include "dashpad/model/pad/viscoelastic_foam.hpp"
#include "input/material_deck/deck_cards.hpp"
#include "input/measurement/measurement_text.hpp"

namespace dashpad::input {

struct DeckLine {
  std::size_t number = 0;
  std::string_view text;
};

/// The columns of the fields of a line.
using Widths = std::vector<std::size_t>;
/// `count` fields of 10 columns each, of 20 in long format.
Widths equal_widths(std::size_t count, bool long_format);

/// A keyword with the lines that belong to it, without comments.
struct DeckBlock {
  std::string keyword;  ///< in capitals
  DeckLine head;
  std::size_t place = 0;     ///< among the keywords of the file
  bool long_format = false;  ///< fields of 20 columns where they are of 10
  std::vector<DeckLine> lines;
};

/// The fields of one line: of fixed widths or, where `free` and the line holds a comma, between commas.
class DeckFields {
 public:
  DeckFields(const DeckLine& line, const Widths& widths, bool free, MeasurementFaults& faults);

  /// A blank field is 0; NaN after a fault.
  double number(std::size_t field, const std::string& key, const DeckUnit& unit = {});
  /// A whole number, positive or negative; a blank field is 0; absent after a fault.
  std::optional<long> whole(std::size_t field, const std::string& key);
  /// The field as it stands, for faults.
  [[nodiscard]] std::string_view text(std::size_t field) const;
  [[nodiscard]] std::size_t line() const { return line_.number; }

 private:
  [[nodiscard]] std::string place_of(std::size_t field) const;

  DeckLine line_;
  std::vector<std::string_view> fields_;
  Widths widths_;  ///< empty where commas separate
  MeasurementFaults& faults_;
};

/// Limits on what a file may ask for.
inline constexpr std::size_t max_foams_of_deck = 500;
inline constexpr std::size_t max_lines_of_curve = 10'000;

/// The blocks with a number, by it. A number that stands twice is a fault.
class NumberedBlocks {
 public:
  explicit NumberedBlocks(std::string kind) : kind_(std::move(kind)) {}

  void add(long id, DeckBlock block, MeasurementFaults& faults);
  [[nodiscard]] const DeckBlock* find(long id) const;
  [[nodiscard]] const DeckBlock* at_place(std::size_t place) const;

 private:
  std::string kind_;  ///< "curve", "function"
  std::map<long, DeckBlock> blocks_;
};

/// The points as they stand, with the line of each.
struct DeckCurve {
  std::string name;      ///< "curve 12", "function 3", for messages
  std::size_t line = 0;  ///< where it begins
  std::vector<double> strain, stress;
  std::vector<std::size_t> lines;
};

struct DeckRateCurve {
  double rate = 0;       ///< 1/s; 0: not stated
  std::size_t line = 0;  ///< where the rate stands
  DeckCurve curve;
};

/// Air in closed cells that a crushed foam carries beside its skeleton: P0 e / (1 - e - phi).
struct DeckAir {
  double pressure = 0;
  double relative_density = 0;
};

struct DeckFoam {
  std::string card;  ///< "*MAT_083"
  std::string title;
  long id = 0;
  std::size_t line = 0;
  bool crushable = false;
  double density = 0;  ///< 0: not stated
  double modulus = 0;  ///< of the unloading of a crushable foam
  double unloading_factor = 1;
  double unloading_shape = 1;
  std::vector<DeckRateCurve> loading;
  std::optional<DeckCurve> unloading;
  DeckAir air;
  bool linear_in_rate = true;
  std::optional<ViscoelasticFoam> viscoelastic;  ///< the whole law; then there are no curves
  std::string basis = "solver card";
  std::string source;
  std::vector<std::string> assumptions, differences;
};

/// The foams of a text; what is wrong is told to `faults`.
std::vector<DeckFoam> read_ls_dyna(std::string_view text, const DeckUnits& units, MeasurementFaults& faults);
std::vector<DeckFoam> read_radioss(std::string_view text, const UnitSystem& system, const DeckUnits& units,
                                   MeasurementFaults& faults);

/// The material; absent after a fault.
std::optional<DeckMaterial> material_of(const DeckFoam& given, MeasurementFaults& faults);

/// A name for a file: letters, digits and hyphens of the title, else the number.
std::string name_for_card(const std::string& title, long id);

/// Says what a field that is set, and has no counterpart here, means.
void tell_if_set(double value, const DeckField& field, DeckFoam& foam);

/// What a blank or 0 leaves to the solver, which takes it for 1: that is an assumption.
double or_one(double given, const std::string& solver_takes, DeckFoam& foam);

/// An exponent of the unloading that is not 1.
void tell_of_exponent(double exponent, const char* name, DeckFoam& foam);

/// The parts of "MAT/LAW90/12/3" between its slashes.
std::vector<std::string> split_at(std::string_view text, char separator);

/// "; there are *MAT_001, *MAT_002": materials that are not read.
std::string others_listed(const std::vector<std::string>& other_materials);

/// What is said of a curve with too many lines.
std::string too_many_points(std::size_t count);

/// What a curve is for: the base curve must rise, a way back may carry nothing at first.
enum class CurveRole { base, rate, unloading };

struct CleanCurve {
  TableCurve table;
  std::vector<std::size_t> lines;        ///< of each point
  std::optional<double> stress_at_zero;  ///< where the deck has a point there that is not 0
};

/// Without what lies at strain 0 and below it; adds to `differences` what was left out. Faults: strains that
/// do not increase or reach 1, stresses that are not positive or do not rise. Absent after one.
std::optional<CleanCurve> clean_curve(const DeckCurve& curve, CurveRole role, MeasurementFaults& faults,
                                      std::vector<std::string>& differences);

/// The stress of a crushed foam that cannot rise faster than along its modulus: points above that line give
/// way to it. Tells `differences`. False after a fault.
bool limit_to_elastic_line(CleanCurve& curve, double modulus, const DeckCurve& deck_curve,
                           MeasurementFaults& faults, std::vector<std::string>& differences);

/// Adds the air to each point. False after a fault.
bool add_air(CleanCurve& curve, const DeckAir& air, const DeckCurve& deck_curve, MeasurementFaults& faults);

}  // namespace dashpad::input
