#pragma once
/// Lines of decks, and the fields in them.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "input/material_deck/deck_unit.hpp"
#include "input/measurement/measurement_text.hpp"

namespace dashpad::input {

struct DeckLine {
  std::size_t number = 0;
  std::string_view text;
};

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
  DeckFields(const DeckLine& line, const std::vector<std::size_t>& widths, bool free,
             MeasurementFaults& faults);

  [[nodiscard]] bool is_blank(std::size_t field) const;
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
  std::vector<std::size_t> widths_;  ///< empty where commas separate
  MeasurementFaults& faults_;
};

/// `count` fields of 10 columns each, of 20 in long format.
std::vector<std::size_t> equal_widths(std::size_t count, bool long_format);

}  // namespace dashpad::input
