#pragma once
/// Decks with the files that they include, as one text.

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "dashpad/input/fault.hpp"
#include "input/measurement/measurement_text.hpp"

namespace dashpad::input {

inline constexpr std::size_t largest_deck = std::size_t{64} << 20;  // bytes, with all files

/// A line of the whole text: where it is from.
struct DeckPlace {
  std::size_t file = 0;  ///< place in DeckText::files
  int line = 0;
};

struct DeckText {
  std::string text;
  std::vector<std::filesystem::path> files;  ///< the deck, and those that it includes
  std::vector<DeckPlace> lines;              ///< empty if nothing was included

  /// Sets file and line of faults of the whole text to those of the file that has the line.
  void place(std::vector<Fault>& faults) const;
  [[nodiscard]] DeckPlace place_of(int line) const;
};

/// The text of a deck, in which each *INCLUDE (LS-DYNA), *INCLUDE, INPUT= (Abaqus) or #include (Radioss) is
/// followed by the lines of that file. The file must be a regular one in the folder of the deck or below it:
/// without "..", an absolute path, a link or a circle; at most 100 files, ten deep.
DeckText with_includes(const std::filesystem::path& deck, std::string_view text, MeasurementFaults& faults);

}  // namespace dashpad::input
