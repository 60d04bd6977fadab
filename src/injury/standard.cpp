#include "dashpad/injury/standard.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

namespace dashpad::injury {

namespace {

/// A member of the standard, and the member of a variant that takes its place.
struct Replaceable {
  const char* name;
  StandardValue Standard::*value;
  std::optional<StandardValue> StandardVariant::*replacement;
};

constexpr Replaceable replaceable[]{{"mass", &Standard::mass, &StandardVariant::mass},
                                    {"radius", &Standard::radius, &StandardVariant::radius},
                                    {"speed", &Standard::speed, &StandardVariant::speed}};

const StandardVariant& find_variant(const Standard& standard, const std::string& name) {
  std::string names;
  for (const StandardVariant& variant : standard.variants) {
    if (variant.name == name) return variant;
    names += (names.empty() ? "" : ", ") + variant.name;
  }
  throw std::invalid_argument(standard.name + " has no variant \"" + name + "\"; " +
                              (names.empty() ? "it has none" : "its variants are " + names));
}

/// The value of a user in place of the standard's.
StandardValue by_user(const StandardValue& standard, std::optional<double> value,
                      std::optional<double> drop_height = {}) {
  return {.value = value,
          .drop_height = drop_height,
          .origin = {.source = "the user", .kind = SourceKind::none, .verified = true, .note = ""},
          .chosen_by_user = true,
          .instead = standard.value};
}

void replace(StandardValue& standard, std::optional<double> value, std::optional<double> drop_height = {}) {
  if (value && !(standard.value && !differ(*value, *standard.value)))
    standard = by_user(standard, value, drop_height);
}

/// Whether the standard has a value that differs from the case's, which is NaN if the case has none.
bool is_choice(const StandardValue& value, double of_case) {
  return value.value && !value.chosen_by_user && differ(*value.value, of_case);
}

using Judged = std::function<Assessment(const Standard&, const ImpactCase&)>;

std::optional<OtherChoice> solved(const Standard& standard, const ImpactCase& given, Kept kept, Kept other,
                                  const Judged& judged) {
  const Kept now{kept.nose != other.nose, kept.speed != other.speed};
  const Standard chosen = with_kept(standard, given.impactor, now);
  const ImpactCase impact = with_impactor_of(chosen, given);
  if (!violations(impact).empty()) return std::nullopt;
  return OtherChoice{.other = other, .kept = now, .assessment = judged(chosen, impact)};
}

std::string above_level(const Criterion& criterion) {
  if (!criterion.has_level()) return "";
  return fmt::format(" above {:.5g} g", criterion.level / standard_gravity);
}

}  // namespace

std::string to_string(SourceKind kind) {
  constexpr const char* names[]{"own text", "secondary", "no source"};
  return names[static_cast<std::size_t>(kind)];
}

std::vector<const ResultQuantity*> limitable_quantities() {
  std::vector<const ResultQuantity*> all;
  for (const ResultQuantity& quantity : result_quantities())
    if (quantity.role.in_studies || quantity.role.doubt == Doubt::of_level) all.push_back(&quantity);
  return all;
}

std::string title_of(const Criterion& criterion) {
  return criterion.quantity->title + above_level(criterion);
}

std::string limit_of(const Criterion& criterion) {
  return "limit on " + title_in_sentence(*criterion.quantity) + above_level(criterion);
}

Standard with_variants(const Standard& standard, const std::vector<std::string>& names) {
  Standard result = standard;
  for (const std::string& name : names) {
    const StandardVariant& variant = find_variant(standard, name);
    for (const auto& [what, value, replacement] : replaceable) {
      if (!(variant.*replacement)) continue;
      for (const std::string& other : result.chosen)
        if (find_variant(standard, other).*replacement)
          throw std::invalid_argument(fmt::format(R"(the variants "{}" and "{}" of {} both set the {})",
                                                  other, name, standard.name, what));
      result.*value = *(variant.*replacement);
    }
    result.chosen.push_back(name);
  }
  return result;
}

Standard with_user_values(const Standard& standard, const UserValues& values) {
  Standard result = standard;
  replace(result.mass, values.mass);
  replace(result.radius, values.radius);
  replace(result.speed, values.speed);
  if (values.drop_height) replace(result.speed, speed_after_fall(*values.drop_height), values.drop_height);
  return result;
}

Standard without_value_of(const Standard& standard, const std::string& key) {
  Standard result = standard;
  const auto give_way = [&](StandardValue& value) {
    if (!value.value) return;
    value.instead = value.value;
    value.chosen_by_user = true;
    value.value.reset();
  };
  if (key == "impactor.speed") give_way(result.speed);
  if (key == "impactor.mass") give_way(result.mass);
  if (key == "impactor.radius") give_way(result.radius);
  return result;
}

/// Unit conversions are exact to many digits, and users give fewer than nine. NaN stands for no value.
bool differ(double one, double other) {
  if (std::isnan(one) || std::isnan(other)) return std::isnan(one) != std::isnan(other);
  return std::abs(one - other) > 1e-9 * std::max(std::abs(one), std::abs(other));
}

double speed_after_fall(double height) { return std::sqrt(2 * standard_gravity * height); }

ImpactCase with_impactor_of(const Standard& standard, const ImpactCase& impact) {
  ImpactCase result = impact;
  result.impactor.mass = standard.mass.value.value_or(impact.impactor.mass);
  if (standard.radius.value) result.impactor.nose = Sphere{*standard.radius.value};
  result.impactor.speed = standard.speed.value.value_or(impact.impactor.speed);
  return result;
}

Standard with_kept(const Standard& standard, const Impactor& of_case, Kept kept) {
  Standard result = standard;
  if (kept.nose && is_choice(standard.radius, sphere_radius(of_case.nose)))
    result.radius = by_user(standard.radius, {});
  if (kept.speed && is_choice(standard.speed, of_case.speed)) result.speed = by_user(standard.speed, {});
  return result;
}

std::vector<OtherChoice> turning_choices(const Standard& standard, const ImpactCase& given, Kept kept,
                                         Verdict verdict, const Judged& judged) {
  std::vector<OtherChoice> turning;
  const auto add = [&](Kept other) {
    std::optional<OtherChoice> choice = solved(standard, given, kept, other, judged);
    if (choice && choice->assessment.verdict != verdict && choice->assessment.verdict != Verdict::undecided)
      turning.push_back(*std::move(choice));
  };
  const bool nose = is_choice(standard.radius, sphere_radius(given.impactor.nose));
  const bool speed = is_choice(standard.speed, given.impactor.speed);
  if (nose) add({.nose = true, .speed = false});
  if (speed) add({.nose = false, .speed = true});
  if (nose && speed && turning.empty()) add({.nose = true, .speed = true});
  return turning;
}

}  // namespace dashpad::injury
