#include "input/material_deck/deck_includes.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "input/disk.hpp"
#include "input/material_deck/include_statements.hpp"
#include "input/measurement/measurement_text.hpp"

namespace dashpad::input {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t max_files = 100, max_depth = 10;

/// Rules for a name, before anything is opened; "" if they are kept.
std::string rule_for_name(const fs::path& folder, const std::string& name) {
  const fs::path given(name);
  if (name.empty() || std::ranges::any_of(name, [](char c) { return static_cast<unsigned char>(c) < ' '; }))
    return "is not the name of a file";
  if (given.is_absolute() || name.find(':') != std::string::npos)
    return "must be in the folder of the deck, or below it";
  if (name.find('\\') != std::string::npos) return "contains a backslash; write the name with / instead";
  fs::path on_the_way = folder;
  for (const fs::path& part : given) {
    if (part == "..") return "must not contain ..";
    on_the_way /= part;
    if (is_link(on_the_way)) return "is a link, or in a folder that is one";
  }
  return "";
}

/// The line as far as its password.
std::string without_password(std::string_view line) {
  constexpr std::string_view word = "PASSWORD";
  const auto at = upper_case(line).find(word);
  return at == std::string::npos ? std::string(line) : std::string(line.substr(0, at)) + "PASSWORD=...";
}

/// Of an included file: what ends it, and not the deck.
bool ends_file(std::string_view line) {
  return is_word(line, "*END") || is_word(line, "/END") || is_word(line, "#ENDDATA");
}

class Expansion {
 public:
  Expansion(const fs::path& deck, std::vector<Fault>& faults)
      : faults_(faults), folder_(deck.parent_path()), whole_{{}, {deck}, {0}, {}} {}

  /// Adds the lines of a file, in which those of another take the place of the statement that includes it.
  void add(std::size_t file, std::string_view text) {
    open_.push_back(file);
    LineReader lines(text);
    IncludeStatements statements;
    for (std::string_view line; lines.next(line);) {
      if (open_.size() > 1 && ends_file(line)) break;
      if (begins_with_word(line, "*INCLUDE_PATH")) has_paths_ = true;
      const DeckPlace place{file, lines.number()};
      const IncludeStatements::Found found = statements.in(line);
      if (found.name)
        include(found, line, place);
      else if (!found.is_part)
        append(line, place);
    }
    open_.pop_back();
  }

  DeckText take() && { return std::move(whole_); }

 private:
  void append(std::string_view line, const DeckPlace& place) {
    whole_.text.append(line);
    whole_.text += '\n';
    whole_.lines.push_back(place);
  }

  void include(const IncludeStatements::Found& found, std::string_view line, const DeckPlace& place) {
    std::string content;
    const std::string rule = found.has_password ? "is encrypted (it needs a PASSWORD), so it cannot be read"
                                                : read(*found.name, content);
    if (!rule.empty()) {
      append(found.has_password ? without_password(line) : std::string(line), place);
      if (faults_.size() < max_files)
        faults_.push_back({"", static_cast<int>(whole_.lines.size()), "include", *found.name, rule});
      return;
    }
    whole_.files.push_back(folder_ / *found.name);
    whole_.includers.push_back(open_.back());
    add(whole_.files.size() - 1, content);
  }

  /// Reads the file of that name; returns the rule that is broken, or "".
  std::string read(const std::string& name, std::string& content) const {
    if (std::string rule = rule_for_name(folder_, name); !rule.empty()) return rule;
    const fs::path file = folder_ / name;
    if (std::ranges::any_of(open_, [&](std::size_t place) { return whole_.files[place] == file; }))
      return "includes itself";
    if (whole_.files.size() >= max_files || open_.size() >= max_depth)
      return fmt::format("is one too many: at most {} files, {} deep", max_files, max_depth);
    if (has_paths_ && !is_there(file)) return "no such file; the folders of *INCLUDE_PATH are not searched";
    const std::size_t room = largest_deck - std::min(largest_deck, whole_.text.size());
    const Reading<std::string> bytes = content_of(file, room);
    if (!bytes) return bytes.faults().front().rule;
    if (bytes->size() > room) return "makes the deck larger than 64 MiB";
    MeasurementFaults faults(name);
    const auto text = reading_of([&] { return std::string(text_in(*bytes, faults)); });
    if (!text) return text.faults().front().rule;
    content = *text;
    return "";
  }

  std::vector<Fault>& faults_;
  fs::path folder_;
  DeckText whole_;
  std::vector<std::size_t> open_;
  bool has_paths_ = false;
};

}  // namespace

DeckPlace DeckText::place_of(std::size_t line) const {
  return line < 1 || line > lines.size() ? DeckPlace{0, line} : lines[line - 1];
}

std::string DeckText::name_of(std::size_t file) const {
  const fs::path folder = files.front().parent_path().lexically_normal();
  return to_utf8(files[file].lexically_normal().lexically_relative(folder).generic_string());
}

bool DeckText::is_repeated(std::size_t file) const {
  const fs::path path = files[file].lexically_normal();
  return std::any_of(files.begin(), files.begin() + static_cast<std::ptrdiff_t>(file),
                     [&](const fs::path& other) { return other.lexically_normal() == path; });
}

std::string DeckText::words_for(std::size_t line) const {
  const DeckPlace place = place_of(line);
  if (files.size() == 1) return fmt::format("line {}", place.line);
  return fmt::format("line {} of {}", place.line, name_of(place.file));
}

void DeckText::place(std::vector<Fault>& faults) const {
  for (Fault& fault : faults) {
    const DeckPlace place = place_of(static_cast<std::size_t>(std::max(fault.line, 0)));
    fault.file = files[place.file].string();
    fault.line = static_cast<int>(place.line);
  }
}

DeckText without_includes(const fs::path& deck, std::string_view text) {
  return {std::string(text), {deck}, {0}, {}};
}

DeckText with_includes(const fs::path& deck, std::string_view text, std::vector<Fault>& faults) {
  Expansion expansion(deck, faults);
  expansion.add(0, text);
  return std::move(expansion).take();
}

}  // namespace dashpad::input
