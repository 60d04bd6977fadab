#pragma once
/// The lines of a material of Radioss, and the functions that it names.

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "input/material_deck/deck_blocks.hpp"

namespace dashpad::input {

using Widths = std::vector<std::size_t>;

struct RadiossSource {
  const RadiossBlocks& deck;
  const DeckUnits& units;
  MeasurementFaults& faults;
};

/// The lines of one material behind its title, taken one after the other.
class LawLines {
 public:
  LawLines(const DeckBlock& block, std::string name, MeasurementFaults& faults)
      : block_(block), name_(std::move(name)), faults_(faults) {}

  /// Absent at the end, which is a fault.
  std::optional<DeckFields> next(const Widths& widths);
  [[nodiscard]] bool at_end() const { return taken_ + 1 >= block_.lines.size(); }
  [[nodiscard]] std::string key(const std::string& field) const { return name_ + ": " + field; }
  [[nodiscard]] std::string title() const;

 private:
  const DeckBlock& block_;
  std::string name_;
  MeasurementFaults& faults_;
  std::size_t taken_ = 0;
  bool told_ = false;
};

/// Says what a field that is filled would have meant to the solver.
void tell_if_filled(DeckFields& line, std::size_t field, const LawLines& of, const char* name,
                    const char* meaning, DeckFoam& foam);

/// 1 where nothing is given, which is an assumption.
double or_default(double given, const char* solver_takes, DeckFoam& foam);

/// The points of a function, stresses times `scale`.
std::optional<DeckCurve> function_of(const RadiossSource& from, long id, double scale, const std::string& key,
                                     std::size_t asked);

/// So many lines with function, rate and scale; false where one is missing or at fault.
bool read_rows(long count, LawLines& lines, const RadiossSource& from, std::vector<DeckRateCurve>& rows);

/// The number of rows; absent where it is none that can be.
std::optional<long> count_in(DeckFields& line, std::size_t field, const LawLines& of, const char* name,
                             long fewest, MeasurementFaults& faults, std::size_t most = most_rates);

/// False where the line is missing.
bool read_density_line(LawLines& lines, const RadiossSource& from, DeckFoam& foam);

}  // namespace dashpad::input
