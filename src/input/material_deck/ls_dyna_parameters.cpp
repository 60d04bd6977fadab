// Parameters of LS-DYNA decks, and the expressions that compute them.

#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include <fmt/format.h>

#include "input/material_deck/ls_dyna.hpp"

namespace dashpad::input {

namespace {

constexpr std::size_t longest_expression = 1000;
constexpr int deepest_brackets = 20;

/// Evaluates an expression from left to right by precedence. Faults are texts; nothing is thrown.
class Expression {
 public:
  Expression(std::string_view text, const DeckParameters& known) : rest_(text), known_(known) {}

  /// The value; absent with a rule in `rule`.
  std::optional<double> value(std::string& rule) {
    const double result = sum();
    skip_blanks();
    if (rule_.empty() && !rest_.empty()) fail(fmt::format("has unexpected text at its end: \"{}\"", rest_));
    if (rule_.empty() && !std::isfinite(result)) fail("is not a finite number");
    rule = rule_;
    return rule_.empty() ? std::optional{result} : std::nullopt;
  }

 private:
  double fail(std::string rule) {
    if (rule_.empty()) rule_ = std::move(rule);
    rest_ = {};
    return 0;
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

  double sum() {
    double total = product();
    while (rule_.empty())
      if (take("+"))
        total += product();
      else if (take("-"))
        total -= product();
      else
        break;
    return total;
  }

  double product() {
    double total = power();
    while (rule_.empty()) {
      skip_blanks();
      if (!rest_.starts_with("**") && take("*")) {
        total *= power();
      } else if (take("/")) {
        const double divisor = power();
        if (divisor == 0 && rule_.empty()) return fail("divides by zero");
        total /= divisor;
      } else {
        break;
      }
    }
    return total;
  }

  double power() {
    if (take("-")) return deeper([&] { return -power(); });
    if (take("+")) return deeper([&] { return power(); });
    const double base = operand();
    if (take("**") || take("^")) return deeper([&] { return std::pow(base, power()); });
    return base;
  }

  template <class Inner>
  double deeper(Inner&& inner) {
    if (++depth_ > deepest_brackets)
      return fail(fmt::format("is nested more than {} levels deep", deepest_brackets));
    const double result = inner();
    --depth_;
    return result;
  }

  double bracket() {
    return deeper([&] {
      const double inner = sum();
      return rule_.empty() && !take(")") ? fail("has an unclosed bracket") : inner;
    });
  }

  double operand() {
    if (take("(")) return bracket();
    skip_blanks();
    if (!rest_.empty() && rest_.front() == '&') rest_.remove_prefix(1);
    std::size_t size = 0;
    const auto is_part_of_name = [](char c) {
      return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
    };
    if (!rest_.empty() && std::isalpha(static_cast<unsigned char>(rest_.front()))) {
      while (size < rest_.size() && is_part_of_name(rest_[size])) ++size;
      const std::string name = lower_case(rest_.substr(0, size));
      rest_.remove_prefix(size);
      return take("(") ? function(name) : named(name);
    }
    for (bool in_exponent = false; size < rest_.size(); ++size) {
      const char c = rest_[size];
      const bool is_sign = (c == '+' || c == '-') && in_exponent;
      in_exponent = c == 'e' || c == 'E' || c == 'd' || c == 'D';
      if (!in_exponent && !is_sign && c != '.' && !std::isdigit(static_cast<unsigned char>(c))) break;
    }
    const ReadNumber read = read_deck_number(rest_.substr(0, size), {});
    if (read.kind != NumberKind::number || size == 0)
      return fail(rest_.empty() ? "ends where a number is needed"
                                : fmt::format("needs a number before \"{}\"", rest_));
    rest_.remove_prefix(size);
    return read.value;
  }

  double named(const std::string& name) {
    if (const auto found = known_.find(name); found != known_.end()) return found->second;
    return name == "pi" ? std::numbers::pi
                        : fail(fmt::format("uses {}, which is not defined above it", name));
  }

  double function(const std::string& name) {
    const double of = bracket();
    using Function = double (*)(double);
    constexpr std::array<std::pair<std::string_view, Function>, 8> functions{
        {{"sqrt", [](double x) { return std::sqrt(x); }},
         {"exp", [](double x) { return std::exp(x); }},
         {"log", [](double x) { return std::log(x); }},
         {"log10", [](double x) { return std::log10(x); }},
         {"abs", [](double x) { return std::abs(x); }},
         {"sin", [](double x) { return std::sin(x); }},
         {"cos", [](double x) { return std::cos(x); }},
         {"tan", [](double x) { return std::tan(x); }}}};
    for (const auto& [known, evaluate] : functions)
      if (name == known) return evaluate(of);
    return fail(fmt::format("uses the function {}, which is not supported", name));
  }

  std::string_view rest_;
  const DeckParameters& known_;
  std::string rule_;
  int depth_ = 0;
};

/// Defines a parameter: "R rho" with the text of its value. Text parameters (C) are left out.
void define(std::string_view name, std::string_view text, std::size_t line, DeckParameters& parameters,
            MeasurementFaults& faults) {
  name = without_blanks(name);
  if (name.empty()) return;
  const char kind = upper_case(name.substr(0, 1)).front();
  const std::string key = lower_case(without_blanks(name.substr(1)));
  if (key.empty() || kind == 'C') return;
  const std::string shown = "parameter " + to_utf8(key);
  if (text.size() > longest_expression)
    return faults.add(line, shown, to_utf8(text), "has too long an expression");
  std::string rule;
  const std::optional<double> value = Expression(text, parameters).value(rule);
  if (!value) return faults.add(line, shown, to_utf8(text), rule);
  if (!parameters.try_emplace(key, kind == 'I' ? std::trunc(*value) : *value).second)
    faults.add(line, shown, "", "is defined twice");
}

}  // namespace

DeckParameters ls_dyna_parameters(std::string_view text, MeasurementFaults& faults) {
  DeckParameters parameters;
  LineReader lines(text);
  bool of_values = false, of_expressions = false;
  for (std::string_view line; lines.next(line);) {
    if (line.starts_with('$')) continue;
    if (line.starts_with('*')) {
      const std::string keyword = upper_case(without_blanks(line.substr(1)));
      of_expressions = keyword.starts_with("PARAMETER_EXPRESSION");
      of_values = !of_expressions &&
                  (keyword == "PARAMETER" || keyword == "PARAMETER_LOCAL" || keyword == "PARAMETER +");
      if (keyword == "END") break;
      continue;
    }
    const bool has_commas = line.find(',') != std::string_view::npos;
    constexpr std::size_t width = 10;
    if (of_expressions) {
      const std::size_t end = has_commas ? line.find(',') : std::min(width, line.size());
      define(line.substr(0, end),
             without_blanks(line.substr(std::min(line.size(), end + (has_commas ? 1 : 0)))), lines.number(),
             parameters, faults);
      continue;
    }
    while (of_values && !without_blanks(line).empty()) {
      const auto take = [&] {
        const std::size_t end =
            has_commas ? std::min(line.find(','), line.size()) : std::min(width, line.size());
        const std::string_view field = line.substr(0, end);
        line.remove_prefix(std::min(line.size(), end + (has_commas ? 1 : 0)));
        return field;
      };
      const std::string_view name = take();
      define(name, without_blanks(take()), lines.number(), parameters, faults);
    }
  }
  return parameters;
}

}  // namespace dashpad::input
