#pragma once
/// Decks as blocks of lines with fields, and the foams that they describe.

#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "dashpad/input/material_deck.hpp"
#include "dashpad/model/pad/foam/hyperfoam_curve.hpp"
#include "dashpad/model/pad/foam/table_curve.hpp"
#include "dashpad/model/pad/viscoelastic_foam.hpp"
#include "input/material_deck/deck_cards.hpp"
#include "input/material_deck/deck_includes.hpp"
#include "input/material_deck/deck_parameters.hpp"
#include "input/material_deck/stated_units.hpp"
#include "input/measurement/measurement_text.hpp"

namespace dashpad::input {

struct DeckLine {
  std::size_t number = 0;
  std::string_view text;
  const DeckParameters* parameters = nullptr;  ///< that its fields may name
};

/// The widths of the fields of a line, in columns.
using Widths = std::vector<std::size_t>;
/// `count` fields of 10 columns, or of 20 in long format.
Widths equal_widths(std::size_t count, bool long_format);

/// A keyword with its lines, without comments.
struct DeckBlock {
  std::string keyword;  ///< in capitals
  DeckLine head;
  std::size_t place = 0;     ///< among the keywords of the file
  bool long_format = false;  ///< fields of 20 columns instead of 10
  std::vector<DeckLine> lines;
};

/// The fields of one line: of fixed widths or, if `free` and the line holds a comma, between commas.
class DeckFields {
 public:
  DeckFields(const DeckLine& line, const Widths& widths, bool free, MeasurementFaults& faults);

  /// A blank field is 0; NaN after a fault.
  double number(std::size_t field, const std::string& key, const DeckUnit& unit = {});
  /// A whole number; a blank field is 0; absent after a fault.
  std::optional<long> whole(std::size_t field, const std::string& key);
  /// The trimmed text of a field.
  [[nodiscard]] std::string_view text(std::size_t field) const {
    return field < fields_.size() ? fields_[field] : std::string_view{};
  }
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

/// Blocks by number. A repeated number is a fault.
class NumberedBlocks {
 public:
  explicit NumberedBlocks(std::string kind) : kind_(std::move(kind)) {}

  void add(long id, DeckBlock block, const DeckText& deck, MeasurementFaults& faults);
  [[nodiscard]] const DeckBlock* find(long id) const;
  [[nodiscard]] const DeckBlock* at_place(std::size_t place) const;

 private:
  std::string kind_;  ///< "curve", "function"
  std::map<long, DeckBlock> blocks_;
  std::set<std::size_t> told_files_;  ///< included twice, which had their fault
};

/// The points of a curve as in the deck, with their lines.
struct DeckCurve {
  std::string name;      ///< "curve 12", "function 3", for messages
  std::size_t line = 0;  ///< where it begins
  std::vector<double> strain = {}, stress = {};
  std::vector<std::size_t> lines = {};
  bool is_moved = false;  ///< its numbers are not those in the lines, and one fault has many

  void add(double of_strain, double of_stress, std::size_t of_line) {
    strain.push_back(of_strain);
    stress.push_back(of_stress);
    lines.push_back(of_line);
  }
  void reverse() {
    std::ranges::reverse(strain);
    std::ranges::reverse(stress);
    std::ranges::reverse(lines);
  }
};

/// The curves of a measured test, in ascending order of strain.
struct MeasuredCurves {
  DeckCurve loading;
  std::optional<DeckCurve> way_back = {};  ///< not above the loading, to its last strain
};

/// The loading of a test along the largest strain so far, and the way back from the largest strain. The curve
/// of the slowest test is made to rise. Adds what was left out or moved to `differences`. The test has
/// points.
MeasuredCurves curves_of_test(const DeckCurve& test, bool is_slowest, std::vector<std::string>& differences);

/// Raises a curve to that of a slower test where it lies below; adds by how much to `differences`.
void raise_to(const DeckCurve& slower, DeckCurve& curve, std::vector<std::string>& differences);

struct DeckRateCurve {
  double rate = 0;       ///< 1/s; 0: not stated
  std::size_t line = 0;  ///< where the rate stands
  DeckCurve curve;
  std::optional<double> temperature = {};  ///< K, of a measured test
};

/// Air in the closed cells of a crushed foam, which adds P0 e / (1 - e - phi) to its skeleton.
struct DeckAir {
  double pressure = 0;
  double relative_density = 0;
};

/// Takes the tests at other temperatures than `reference`, K, out of `tests`: each of these temperatures gets
/// a factor on the stresses at `reference` in tests at the same rate. Adds how well these follow to
/// `differences`. The table is empty if there are none; then `differences` name the temperature.
TemperatureTable take_temperatures(std::vector<DeckRateCurve>& tests, double reference,
                                   std::vector<std::string>& differences, MeasurementFaults& faults);

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
  std::optional<HyperfoamCurve> hyperfoam;       ///< the base curve, in place of points of the first loading
  TemperatureTable temperature_table;
  std::string basis = "solver card";
  std::string source;
  std::string units;  ///< of its numbers in the deck, in words; empty for a table
  std::vector<std::string> assumptions, differences;
};

/// The foams of a deck. Faults are added to `faults`.
std::vector<DeckFoam> read_ls_dyna(const DeckText& text, UnitChoice& units, MeasurementFaults& faults);
std::vector<DeckFoam> read_radioss(const DeckText& text, UnitChoice& units, MeasurementFaults& faults);
std::vector<DeckFoam> read_abaqus(const DeckText& deck, UnitChoice& units, MeasurementFaults& faults);
/// Whether the keywords of a text are those of Abaqus.
bool is_abaqus(std::string_view text);

/// The material; absent after a fault.
std::optional<DeckMaterial> material_of(const DeckFoam& given, MeasurementFaults& faults);

/// A name for a file: letters, digits and hyphens of the title, or the number.
std::string name_for_card(const std::string& title, long id);

/// Reports the meaning of a field that is set but has no counterpart here.
void tell_if_set(double value, const DeckField& field, DeckFoam& foam);

/// The given value, or 1 for a blank or 0; then adds an assumption that ends in `consequence`.
double or_one(double given, const char* name, DeckFoam& foam,
              const char* consequence = ", which the solver treats as 1");

/// Reports an exponent of the unloading that is not 1.
void tell_of_exponent(double exponent, const char* name, DeckFoam& foam);

/// The parts of "MAT/LAW90/12/3" between its slashes.
std::vector<std::string> split_at(std::string_view text, char separator);

/// The text without blanks and quotes around it.
std::string unquoted(std::string_view text);

/// What a deck holds besides the blocks that are read.
struct OutOfReach {
  std::string include;                       ///< "*INCLUDE" if the deck includes files that were not read
  std::string other_include;                 ///< a keyword such as *INCLUDE_TRANSFORM, which is never read
  std::string encrypted;                     ///< "line 4": where the first encrypted part begins
  std::vector<std::string> other_materials;  ///< keywords, each of them once

  /// Notes the keyword of a material that is not read, up to ten of them.
  void add_material(const std::string& keyword);
};

/// The rule for a block that is not in the deck.
std::string missing(const std::string& block, const OutOfReach& why);

/// The rule for a deck without the materials that are read, with what it holds.
std::string contains_no(const char* materials, const OutOfReach& why);

/// The rule for a curve with too many points.
std::string too_many_points(std::size_t count);

/// The use of a curve: the base curve must rise; a way back may begin without stress.
enum class CurveRole { base, rate, unloading };

struct CleanCurve {
  TableCurve table;
  std::vector<std::size_t> lines;        ///< of each point
  std::optional<double> stress_at_zero;  ///< if the deck has a point there that is not 0
};

/// The curve without points at or below strain 0; adds omissions to `differences`. Faults: strains that do
/// not increase or reach 1, stresses that are not positive or do not rise. Absent after a fault.
std::optional<CleanCurve> clean_curve(const DeckCurve& curve, CurveRole role, MeasurementFaults& faults,
                                      std::vector<std::string>& differences);

/// Limits a crushed foam's stress to the line of its modulus; says so in `differences`. False after a fault.
bool limit_to_elastic_line(CleanCurve& curve, double modulus, const DeckCurve& deck_curve,
                           MeasurementFaults& faults, std::vector<std::string>& differences);

bool add_air(CleanCurve& curve, const DeckAir& air, const DeckCurve& deck_curve, MeasurementFaults& faults);

}  // namespace dashpad::input
