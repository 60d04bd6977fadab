#include "input/material_deck/deck_parameters.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include <fmt/format.h>

#include "input/material_deck/deck_cards.hpp"

namespace dashpad::input {

namespace {

constexpr std::size_t longest_expression = 1000;
constexpr int deepest_brackets = 20;

bool is_part_of_name(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

using NamedFunction = std::pair<std::string_view, double (*)(double)>;
constexpr std::array<NamedFunction, 8> functions{{{"sqrt", [](double x) { return std::sqrt(x); }},
                                                  {"exp", [](double x) { return std::exp(x); }},
                                                  {"log", [](double x) { return std::log(x); }},
                                                  {"log10", [](double x) { return std::log10(x); }},
                                                  {"abs", [](double x) { return std::abs(x); }},
                                                  {"sin", [](double x) { return std::sin(x); }},
                                                  {"cos", [](double x) { return std::cos(x); }},
                                                  {"tan", [](double x) { return std::tan(x); }}}};

std::string known_functions() {
  std::string names;
  for (const auto& [name, evaluate] : functions) names += (names.empty() ? "" : ", ") + std::string(name);
  return names;
}

/// Evaluates an expression from left to right by precedence. Faults are texts; nothing is thrown.
class Expression {
 public:
  /// `undefined` ends the sentence about a name that is not known.
  Expression(std::string_view text, const DeckParameters& known, std::string undefined)
      : rest_(text), known_(known), undefined_(std::move(undefined)) {}

  /// The value, NaN if it depends on a parameter with a fault; absent with a rule in `rule`.
  std::optional<DeckParameter> value(std::string& rule) {
    DeckParameter result = sum();
    skip_blanks();
    if (rule_.empty() && !rest_.empty()) fail(fmt::format("has unexpected text at its end: \"{}\"", rest_));
    if (uses_faulty_)
      result.value = std::numeric_limits<double>::quiet_NaN();
    else if (rule_.empty() && !std::isfinite(result.value))
      fail("is not a finite number");
    rule = rule_;
    return rule_.empty() ? std::optional{result} : std::nullopt;
  }

 private:
  DeckParameter fail(std::string rule) {
    if (rule_.empty()) rule_ = std::move(rule);
    rest_ = {};
    return {};
  }

  void skip_blanks() {
    while (!rest_.empty() && (rest_.front() == ' ' || rest_.front() == '\t')) rest_.remove_prefix(1);
  }

  bool take(std::string_view sign) {
    skip_blanks();
    if (!rest_.starts_with(sign)) return false;
    rest_.remove_prefix(sign.size());
    return true;
  }

  DeckParameter sum() {
    DeckParameter total = product();
    while (rule_.empty()) {
      const bool is_added = take("+");
      if (!is_added && !take("-")) break;
      const DeckParameter term = product();
      total = {is_added ? total.value + term.value : total.value - term.value,
               total.is_whole && term.is_whole};
    }
    return total;
  }

  DeckParameter product() {
    DeckParameter total = power();
    while (rule_.empty()) {
      skip_blanks();
      if (!rest_.starts_with("**") && take("*")) {
        const DeckParameter factor = power();
        total = {total.value * factor.value, total.is_whole && factor.is_whole};
      } else if (take("/")) {
        total = quotient(total, power());
      } else {
        break;
      }
    }
    return total;
  }

  DeckParameter quotient(const DeckParameter& dividend, const DeckParameter& divisor) {
    if (!rule_.empty()) return {};
    if (divisor.value == 0 && !uses_faulty_) return fail("divides by zero");
    if (known_.language().is_python && dividend.is_whole && divisor.is_whole)
      return fail("divides whole numbers, which Abaqus may round down; write one with a decimal point");
    return {dividend.value / divisor.value};
  }

  DeckParameter power() {
    if (take("-"))
      return deeper([&]() -> DeckParameter {
        const DeckParameter of = power();
        return {-of.value, of.is_whole};
      });
    if (take("+")) return deeper([&] { return power(); });
    const DeckParameter base = operand();
    if (take("**") || (!known_.language().is_python && take("^")))
      return deeper([&]() -> DeckParameter {
        const DeckParameter exponent = power();
        return {std::pow(base.value, exponent.value),
                base.is_whole && exponent.is_whole && exponent.value >= 0};
      });
    return base;
  }

  template <class Inner>
  DeckParameter deeper(Inner&& inner) {
    if (++depth_ > deepest_brackets)
      return fail(fmt::format("is nested more than {} levels deep", deepest_brackets));
    const DeckParameter result = inner();
    --depth_;
    return result;
  }

  DeckParameter bracket() {
    return deeper([&] {
      const DeckParameter inner = sum();
      return rule_.empty() && !take(")") ? fail("has an unclosed bracket") : inner;
    });
  }

  DeckParameter operand() {
    if (take("(")) return bracket();
    skip_blanks();
    if (!rest_.empty() && rest_.front() == '&') rest_.remove_prefix(1);
    std::size_t size = 0;
    if (rest_.empty() || !std::isalpha(static_cast<unsigned char>(rest_.front()))) return number();
    while (size < rest_.size() && is_part_of_name(rest_[size])) ++size;
    const std::string name = lower_case(rest_.substr(0, size));
    rest_.remove_prefix(size);
    return take("(") ? function(name) : named(name);
  }

  DeckParameter number() {
    std::size_t size = 0;
    bool is_whole = true;
    for (bool in_exponent = false; size < rest_.size(); ++size) {
      const char c = rest_[size];
      const bool is_sign = (c == '+' || c == '-') && in_exponent;
      in_exponent = c == 'e' || c == 'E' || c == 'd' || c == 'D';
      const bool is_figure = std::isdigit(static_cast<unsigned char>(c)) != 0;
      if (!in_exponent && !is_sign && c != '.' && !is_figure) break;
      is_whole = is_whole && is_figure;
    }
    const std::string_view written = rest_.substr(0, size);
    const ReadNumber read = read_deck_number(written, {});
    if (read.kind == NumberKind::out_of_range)
      return fail(fmt::format("has a number that is too {}: {}",
                              written.find('-') == std::string_view::npos ? "large" : "small", written));
    if (read.kind != NumberKind::number || size == 0)
      return fail(rest_.empty() ? "ends where a number is needed"
                                : fmt::format("needs a number before \"{}\"", rest_));
    rest_.remove_prefix(size);
    return {read.value, is_whole};
  }

  DeckParameter named(const std::string& name) {
    if (const DeckParameter* const found = known_.find(name)) {
      uses_faulty_ = uses_faulty_ || std::isnan(found->value);
      return *found;
    }
    if (name == "pi") return {std::numbers::pi};
    return fail(fmt::format("uses {}, which {}", name, undefined_));
  }

  DeckParameter function(const std::string& name) {
    const auto found = std::ranges::find(functions, name, &NamedFunction::first);
    if (found == functions.end())
      return fail(fmt::format("uses the function {}, which is not supported; those that are: {}", name,
                              known_functions()));
    return {found->second(bracket().value)};
  }

  std::string_view rest_;
  const DeckParameters& known_;
  std::string undefined_;
  std::string rule_;
  int depth_ = 0;
  bool uses_faulty_ = false;
};

/// The value of a definition; absent with a rule in `rule`.
std::optional<DeckParameter> value_of(const ParameterDefinition& definition, const DeckParameters& known,
                                      std::string& rule) {
  if (definition.value.size() > longest_expression) {
    rule = "has too long an expression";
    return std::nullopt;
  }
  if (!definition.is_expression)
    if (const ReadNumber read = read_deck_number(definition.value, {}); read.kind == NumberKind::number)
      return DeckParameter{read.value};
  return Expression(definition.value, known, "is not defined above it").value(rule);
}

/// Rounds what is a whole number but for the errors of its expression.
void make_whole(DeckParameter& parameter, std::string& rule) {
  constexpr double tolerance = 1e-9;
  const double whole = std::round(parameter.value);
  const bool is_near = std::abs(parameter.value - whole) <= tolerance * std::max(1.0, std::abs(whole));
  if (rule.empty() && !std::isnan(parameter.value) && !is_near)
    rule = fmt::format("must be a whole number, not {:g}", parameter.value);
  parameter.value = is_near ? whole : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

bool DeckParameters::add(std::string_view name, const DeckParameter& parameter) {
  return parameters_.try_emplace(lower_case(name), parameter).second;
}

void DeckParameters::add_unreadable(std::string_view name) { unreadable_.insert(lower_case(name)); }

const DeckParameter* DeckParameters::find(std::string_view name) const {
  const std::string key = lower_case(name);
  for (const DeckParameters* scope = this; scope != nullptr; scope = scope->outer_)
    if (const auto found = scope->parameters_.find(key); found != scope->parameters_.end())
      return &found->second;
  static constexpr DeckParameter unreadable{std::numeric_limits<double>::quiet_NaN()};
  for (const DeckParameters* scope = this; scope != nullptr; scope = scope->outer_)
    if (scope->unreadable_.contains(key)) return &unreadable;
  return nullptr;
}

std::vector<std::string_view> words_in(std::string_view text) {
  std::vector<std::string_view> words;
  while (!text.empty()) {
    const auto end = static_cast<std::size_t>(std::ranges::find_if_not(text, is_part_of_name) - text.begin());
    if (end > 0) words.push_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return words;
}

std::optional<ParameterUse> parameter_use(std::string_view written, const DeckParameters& known) {
  const bool is_negative = written.starts_with('-');
  std::string_view text = written;
  if (is_negative || text.starts_with('+')) text = without_blanks(text.substr(1));
  const std::string undefined =
      fmt::format("is not defined by any {} in this deck", known.language().keyword);
  ParameterUse use;
  if (text.starts_with('&')) {
    const DeckParameter* const found = known.find(without_blanks(text.substr(1)));
    if (found == nullptr) return ParameterUse{0, undefined};
    use.value = found->value;
  } else if (text.size() > 1 && text.starts_with('<') && text.ends_with('>')) {
    if (text.size() > longest_expression) return ParameterUse{0, "has too long an expression"};
    const auto result = Expression(text.substr(1, text.size() - 2), known, undefined).value(use.rule);
    if (!result) return use;
    use.value = result->value;
  } else {
    return std::nullopt;
  }
  if (is_negative) use.value = -use.value;
  return use;
}

bool define_parameter(const ParameterDefinition& definition, const DeckParameters& known,
                      DeckParameters& scope, MeasurementFaults& faults) {
  const std::string shown = "parameter " + to_utf8(lower_case(definition.name));
  std::string rule;
  DeckParameter parameter =
      value_of(definition, known, rule).value_or(DeckParameter{std::numeric_limits<double>::quiet_NaN()});
  if (definition.is_whole) make_whole(parameter, rule);
  if (!rule.empty()) faults.add(definition.line, shown, to_utf8(definition.value), rule);
  if (scope.add(definition.name, parameter)) return rule.empty();
  if (rule.empty()) faults.add(definition.line, shown, "", "is defined twice");
  return false;
}

}  // namespace dashpad::input
