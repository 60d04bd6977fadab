#include "input/material_deck/deck_includes.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "input/disk.hpp"
#include "quantities/text.hpp"

namespace dashpad::input {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t max_files = 100, max_depth = 10;

bool begins_with(std::string_view line, std::string_view word) {
  return line.size() >= word.size() && std::ranges::equal(line.substr(0, word.size()), word, {}, [](char c) {
           return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
         });
}

/// The name behind the word in a line: "*INCLUDE, INPUT=foam.inc", "#include foam.inc".
std::string_view name_in(std::string_view line, std::string_view word) {
  line = without_blanks(line.substr(word.size()));
  while (line.size() > 1 && (line.front() == '"' || line.front() == '\''))
    line = line.substr(1, line.find(line.front(), 1) - 1);
  return line;
}

/// Rules for a name, before anything is opened; "" if they are kept.
std::string rule_for_name(const fs::path& folder, const std::string& name) {
  const fs::path given(name);
  if (name.empty() || std::ranges::any_of(name, [](char c) { return static_cast<unsigned char>(c) < ' '; }))
    return "is not the name of a file";
  if (given.is_absolute() || name.find('\\') != std::string::npos || name.find(':') != std::string::npos)
    return "must be in the folder of the deck, or below it";
  fs::path on_the_way = folder;
  for (const fs::path& part : given) {
    if (part == "..") return "must not contain ..";
    on_the_way /= part;
    if (is_link(on_the_way)) return "is a link, or in a folder that is one";
  }
  return "";
}

class Expansion {
 public:
  Expansion(const fs::path& deck, MeasurementFaults& faults) : faults_(faults), folder_(deck.parent_path()) {
    whole_.files.push_back(deck);
  }

  /// Adds the lines of a file, and after each line that includes another those of that.
  void add(std::size_t file, std::string_view text) {
    open_.push_back(file);
    LineReader lines(text);
    bool name_follows = false;  // LS-DYNA names the file in the line below
    for (std::string_view line; lines.next(line);) {
      whole_.lines.push_back({file, static_cast<int>(lines.number())});
      std::optional<std::string> name;
      const bool begins = begins_with(line, "*INCLUDE") && without_blanks(line).size() == 8;
      const bool is_blank_line = without_blanks(line).empty();
      const bool still_follows = name_follows && (line.starts_with('$') || is_blank_line);
      // The end of an included file is not that of the deck.
      const bool ends = open_.size() > 1 && begins_with(line, "*END") && without_blanks(line).size() == 4;
      if (name_follows && !still_follows) {
        name = without_blanks(line);
      } else if (begins_with(line, "*INCLUDE,")) {
        const auto at = std::min(line.find('='), line.size() - 1);
        name = name_in(line, line.substr(0, at + 1));
      } else if (begins_with(line, "#INCLUDE ")) {
        name = name_in(line, "#INCLUDE ");
      }
      name_follows = begins || still_follows;
      // What has been read is a comment to the readers of decks, and still a line.
      const char* const mark = line.starts_with('#') ? "##" : begins_with(line, "*INCLUDE,") ? "**" : "$";
      const bool is_done = name || begins || ends;
      if (is_done) whole_.text.append(mark);
      whole_.text.append(line.substr(is_done && !line.empty() ? 1 : 0));
      whole_.text += '\n';
      if (name) include(*name);
    }
    open_.pop_back();
  }

  DeckText take() && {
    if (whole_.files.size() == 1) whole_.lines.clear();
    return std::move(whole_);
  }

 private:
  void include(const std::string& name) {
    const std::size_t line = whole_.lines.size();
    const fs::path file = folder_ / name;
    std::string rule = rule_for_name(folder_, name);
    const auto is_open = [&](std::size_t place) { return whole_.files[place] == file; };
    if (rule.empty() && std::ranges::any_of(open_, is_open)) rule = "includes itself";
    if (rule.empty() && (whole_.files.size() >= max_files || open_.size() >= max_depth))
      rule = fmt::format("is one too many: at most {} files, {} deep", max_files, max_depth);
    if (!rule.empty()) return faults_.add(line, "include", name, std::move(rule));
    const std::size_t room = largest_deck - std::min(largest_deck, whole_.text.size());
    const Reading<std::string> read = content_of(file, room);
    if (!read) return faults_.add(line, "include", name, read.faults().front().rule);
    if (read->size() > room) return faults_.add(line, "include", name, "makes the deck larger than 64 MiB");
    whole_.files.push_back(file);
    add(whole_.files.size() - 1, *read);
  }

  MeasurementFaults& faults_;
  fs::path folder_;
  DeckText whole_;
  std::vector<std::size_t> open_;
};

}  // namespace

DeckPlace DeckText::place_of(int line) const {
  if (line < 1 || static_cast<std::size_t>(line) > lines.size()) return {0, line};
  return lines[static_cast<std::size_t>(line) - 1];
}

void DeckText::place(std::vector<Fault>& faults) const {
  for (Fault& fault : faults) {
    const DeckPlace place = place_of(fault.line);
    fault.file = files[place.file].string();
    fault.line = place.line;
  }
}

DeckText with_includes(const fs::path& deck, std::string_view text, MeasurementFaults& faults) {
  Expansion expansion(deck, faults);
  expansion.add(0, text);
  return std::move(expansion).take();
}

}  // namespace dashpad::input
