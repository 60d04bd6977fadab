// *PARAMETER and *PARAMETER_EXPRESSION of LS-DYNA.

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "input/material_deck/ls_dyna.hpp"

namespace dashpad::input {

namespace {

/// The options behind *PARAMETER; `is_read` unless one of them makes it another keyword.
struct ParameterOptions {
  bool is_read = false, is_expression = false, is_local = false, is_long = false;
};

ParameterOptions options_of(const DeckBlock& block) {
  const std::vector<std::string> words = split_at(block.keyword, '_');
  ParameterOptions options{.is_read = words.front() == "PARAMETER", .is_long = block.long_format};
  for (std::size_t i = 1; i < words.size(); ++i) {
    options.is_expression = options.is_expression || words[i] == "EXPRESSION";
    options.is_local = options.is_local || words[i] == "LOCAL";
    options.is_read = options.is_read && (words[i] == "EXPRESSION" || words[i] == "LOCAL" ||
                                          words[i] == "MUTABLE" || words[i] == "NOECHO");
  }
  return options;
}

/// Reads the lines of the blocks one after the other.
class ParameterReader {
 public:
  ParameterReader(const DeckText& deck, LsDynaScopes& scopes, MeasurementFaults& faults)
      : deck_(deck), scopes_(scopes), faults_(faults) {}

  void begin(const ParameterOptions& options) {
    finish();
    options_ = options;
  }

  void line(const DeckLine& line) {
    if (!options_.is_read) return;
    rest_ = line.text;
    column_ = 0;
    const auto comma = rest_.find(',');
    // In an expression, a comma behind a bracket is between the arguments of a function.
    has_commas_ = comma != std::string_view::npos &&
                  !(options_.is_expression && rest_.substr(0, comma).find('(') != std::string_view::npos);
    if (options_.is_expression) return expression(line.number);
    while (!without_blanks(rest_).empty()) {
      const std::size_t column = column_;
      const std::string_view name = field();
      const std::string_view value = without_blanks(field());
      if (!define({name, std::string(value), line.number, column})) return;
    }
  }

  /// Defines what has been begun.
  void finish() {
    if (begun_) define(*std::exchange(begun_, std::nullopt));
  }

 private:
  /// A name with its type, such as "R rho".
  struct Typed {
    std::string_view name;
    std::string value;
    std::size_t line = 0, column = 0;
  };

  [[nodiscard]] std::size_t width() const { return options_.is_long ? 20 : 10; }

  std::string_view field() {
    const std::size_t end =
        has_commas_ ? std::min(rest_.find(','), rest_.size()) : std::min(width(), rest_.size());
    const std::string_view text = rest_.substr(0, end);
    rest_.remove_prefix(std::min(rest_.size(), end + (has_commas_ ? 1 : 0)));
    column_ += width();
    return text;
  }

  /// An expression goes on in lines without a name.
  void expression(std::size_t number) {
    const std::string_view name = field();
    const std::string_view text = without_blanks(rest_);
    if (begun_ && without_blanks(name).empty()) {
      begun_->value += " " + std::string(text);
      return;
    }
    finish();
    begun_ = Typed{name, std::string(text), number, 0};
  }

  /// False if the rest of the line is not to be read: after a fault, or because it is text (C).
  bool define(const Typed& given) {
    const std::string_view typed = without_blanks(given.name);
    if (typed.empty()) return true;
    const std::string kind = upper_case(typed.substr(0, 1));
    const std::string_view name = without_blanks(typed.substr(1));
    if (kind == "C") return false;
    if (std::string rule = rule_for(kind, name); !rule.empty()) {
      if (!has_commas_) rule += fmt::format(" (columns {} to {})", given.column + 1, given.column + width());
      faults_.add(given.line, "parameter", to_utf8(typed), std::move(rule));
      skip(given.name);
      skip(given.value);
      if (!options_.is_expression) skip(rest_);
      return false;
    }
    const std::size_t file = deck_.place_of(given.line).file;
    if (!options_.is_local && deck_.is_repeated(file)) return true;  // the same once more
    const ParameterDefinition definition{.name = name,
                                         .value = given.value,
                                         .line = given.line,
                                         .is_expression = options_.is_expression,
                                         .is_whole = kind == "I"};
    return define_parameter(definition, scopes_.of(file),
                            options_.is_local ? scopes_.local_to(file) : scopes_.of_all(), faults_);
  }

  static std::string rule_for(const std::string& kind, std::string_view name) {
    if ((kind != "R" && kind != "I") || name.empty())
      return "must be the type R, I or C and a name; a value before it may be in the wrong columns";
    return name.find_first_of(" \t") == std::string_view::npos ? "" : "must be one name without blanks";
  }

  /// The names in a text that is not read, with their types before them or not, cause no other fault.
  void skip(std::string_view text) {
    for (const std::string_view word : words_in(text)) {
      scopes_.of_all().add_unreadable(word);
      scopes_.of_all().add_unreadable(word.substr(1));
    }
  }

  const DeckText& deck_;
  LsDynaScopes& scopes_;
  MeasurementFaults& faults_;
  ParameterOptions options_;
  std::optional<Typed> begun_;  ///< an expression that may go on
  std::string_view rest_;       ///< of the line
  std::size_t column_ = 0;      ///< where it begins
  bool has_commas_ = false;
};

}  // namespace

LsDynaScopes::LsDynaScopes(const DeckText& deck) {
  scopes_.emplace_back(ls_dyna_language);
  for (std::size_t file = 0; file < deck.files.size(); ++file)
    scopes_.emplace_back(ls_dyna_language, file == 0 ? &scopes_.front() : &scopes_[deck.includers[file] + 1]);
}

void read_ls_dyna_parameters(const DeckText& deck, LsDynaScopes& scopes, MeasurementFaults& faults) {
  ParameterReader reader(deck, scopes, faults);
  LineReader lines(deck.text);
  bool all_long = false;
  for (std::string_view line; lines.next(line);) {
    if (line.starts_with('$')) continue;
    if (!line.starts_with('*')) {
      reader.line({lines.number(), line});
      continue;
    }
    const DeckBlock block = begun_block({lines.number(), line}, all_long);
    if (block.keyword == "END") break;
    if (block.keyword == "KEYWORD" && says_long(line)) all_long = true;
    reader.begin(options_of(block));
  }
  reader.finish();
}

}  // namespace dashpad::input
