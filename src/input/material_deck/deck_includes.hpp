#pragma once
/// Decks with the files that they include, as one text.

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "dashpad/input/fault.hpp"

namespace dashpad::input {

inline constexpr std::size_t largest_deck = std::size_t{64} << 20;  // bytes, with all files

/// A line of the whole text: where it is from.
struct DeckPlace {
  std::size_t file = 0;  ///< place in DeckText::files
  std::size_t line = 0;
};

struct DeckText {
  std::string text;
  std::vector<std::filesystem::path> files;  ///< the deck, and those that it includes
  std::vector<std::size_t> includers;        ///< of each file, the file that includes it; 0 of the deck
  std::vector<DeckPlace> lines;              ///< empty for a deck alone, whose lines are those of the text

  [[nodiscard]] DeckPlace place_of(std::size_t line) const;
  /// The name of a file as seen from the folder of the deck, UTF-8.
  [[nodiscard]] std::string name_of(std::size_t file) const;
  /// Whether the file has been included before.
  [[nodiscard]] bool is_repeated(std::size_t file) const;
  /// "line 4", or "line 4 of curves.k" if the text is from several files.
  [[nodiscard]] std::string words_for(std::size_t line) const;
  /// Sets file and line of faults of the whole text to those of the file that has the line.
  void place(std::vector<Fault>& faults) const;
};

/// A deck alone.
DeckText without_includes(const std::filesystem::path& deck, std::string_view text);

/// The text of a deck with the lines of each file in place of the statement that includes it: *INCLUDE with
/// one or more names below it (LS-DYNA), *INCLUDE, INPUT= (Abaqus) or #include (Radioss). The file must be a
/// regular one in the folder of the deck or below it: without "..", an absolute path, a link or a circle; at
/// most 100 files, ten deep. Faults are lines of the whole text.
DeckText with_includes(const std::filesystem::path& deck, std::string_view text, std::vector<Fault>& faults);

}  // namespace dashpad::input
