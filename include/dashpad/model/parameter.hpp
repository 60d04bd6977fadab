#pragma once
/// The numbers of a case as tables beside their structures: key, unit, admissible range, meaning.

#include <optional>
#include <string>
#include <string_view>

#include "dashpad/quantities/constants.hpp"

namespace dashpad {

/// Physically possible values of a parameter (not the range of a fit; see FittedRange).
struct Bounds {
  double lowest = -infinite;
  double highest = infinite;
  bool lowest_admitted = false;
  bool highest_admitted = false;
  /// Both limits lie beyond any real impact; the rule then names them as a range, in rule_of().
  bool is_wide = false;
  /// Wording of the rule after "must be "; "" where it follows from the numbers.
  const char* words = "";

  /// False for NaN and for infinities as well.
  [[nodiscard]] constexpr bool contain(double value) const {
    if (!(value > -infinite && value < infinite)) return false;
    return (value > lowest || (lowest_admitted && value == lowest)) &&
           (value < highest || (highest_admitted && value == highest));
  }
};

/// Greater than zero.
inline constexpr Bounds positive{.lowest = 0};
/// Zero or greater.
inline constexpr Bounds not_negative{.lowest = 0, .lowest_admitted = true};

/// Between two values, both admitted.
constexpr Bounds from_to(double lowest, double highest) { return {lowest, highest, true, true}; }
/// Above one value, and at most another.
constexpr Bounds above_to(double lowest, double highest) { return {lowest, highest, false, true}; }

/// Positive, between two values that no real impact lies outside of; both are admitted.
constexpr Bounds wide(double lowest, double highest) { return {lowest, highest, true, true, true, ""}; }

/// Bounds whose rule reads "must be " and `words`. The highest value is admitted.
constexpr Bounds in_words(double lowest, double highest, const char* words, bool lowest_admitted = true) {
  return {lowest, highest, lowest_admitted, true, false, words};
}

/// Pointer to the member of `Owner` that holds a number: a plain one, an optional one, or a count.
template <class Owner>
class Member {
 public:
  constexpr Member(double Owner::*number) : number_(number) {}
  constexpr Member(std::optional<double> Owner::*optional) : optional_(optional) {}
  constexpr Member(int Owner::*count) : count_(count) {}

  /// The number in SI; NaN where it is absent.
  [[nodiscard]] double of(const Owner& owner) const {
    if (number_ != nullptr) return owner.*number_;
    if (count_ != nullptr) return owner.*count_;
    return (owner.*optional_).value_or(no_value);
  }
  void set(Owner& owner, double value) const {
    if (number_ != nullptr)
      owner.*number_ = value;
    else if (count_ != nullptr)
      owner.*count_ = static_cast<int>(value);
    else
      owner.*optional_ = value;
  }
  [[nodiscard]] bool is_count() const { return count_ != nullptr; }
  [[nodiscard]] bool is_absent(const Owner& owner) const {
    return optional_ != nullptr && !(owner.*optional_);
  }
  friend constexpr bool operator==(const Member&, const Member&) = default;

 private:
  double Owner::*number_ = nullptr;
  std::optional<double> Owner::*optional_ = nullptr;
  int Owner::*count_ = nullptr;
};

/// The treatment of a number that a case leaves out.
enum class LeftOut {
  refused,     ///< it must be given
  as_default,  ///< it has the value of a default-constructed owner
  none,        ///< the feature is absent: the value is 0, cannot be varied, and a case must not state it
  zero,        ///< the same, but a case may also state 0
  computed     ///< follows from the rest of the case or an option; written cases always state it
};

/// One entry of a parameter table: the only place that names a number of a case. The tables serve case files,
/// --set, checks, listings, JSON, what studies and fits vary, documents and tests alike.
template <class Owner>
struct Parameter {
  const char* key;     ///< name in case files and in results
  const char* symbol;  ///< symbol in theory.md, or ""
  const char* unit;    ///< SI unit, such as "N s/m"; "1" for a pure number
  Member<Owner> member;
  Bounds bounds;
  const char* meaning;
  LeftOut left_out = LeftOut::refused;
  const char* since = "0.1.0";  ///< first version of the program that has it

  [[nodiscard]] double of(const Owner& owner) const { return member.of(owner); }
  void set(Owner& owner, double value) const { member.set(owner, value); }
  [[nodiscard]] bool is_absent(const Owner& owner) const { return member.is_absent(owner); }
  [[nodiscard]] bool may_be_left_out() const { return left_out != LeftOut::refused; }
  /// Whether the number is absent, or 0 where that means that the feature is absent.
  [[nodiscard]] bool is_none(const Owner& owner) const {
    return is_absent(owner) || ((left_out == LeftOut::none || left_out == LeftOut::zero) && of(owner) == 0);
  }
  /// Whether leaving the number out gives the same case.
  [[nodiscard]] bool goes_without_saying(const Owner& owner) const {
    return may_be_left_out() && left_out != LeftOut::computed &&
           (is_absent(owner) || of(owner) == of(Owner()));
  }
};

/// A value that breaks a rule: its key, the value in SI, and the rule in words.
struct Violation {
  std::string key;
  double value = 0;
  std::string rule;
};

/// The rule that bounds express: "must be at least 0 kg/m2".
std::string rule_of(const Bounds& bounds, std::string_view unit);

/// The rule that a value breaks, if any: its bounds, or 1e-15 and 1e15, beyond which products may overflow.
std::optional<std::string> broken_rule(double value, const Bounds& bounds, std::string_view unit);

}  // namespace dashpad
