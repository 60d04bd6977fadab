#include "dashpad/injury/other_choice.hpp"

#include <optional>

namespace dashpad::injury {

namespace {

/// A value of the standard that is not the case's, NaN where the case has none.
bool is_choice(const StandardValue& value, double of_case) {
  return value.value && !value.chosen_by_user && differ(*value.value, of_case);
}

void leave_to_case(StandardValue& value) {
  value = {.value = {},
           .drop_height = {},
           .origin = {.source = "the user", .kind = SourceKind::none, .verified = true, .note = ""},
           .chosen_by_user = true,
           .instead = value.value};
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

}  // namespace

Standard with_kept(const Standard& standard, const Impactor& of_case, Kept kept) {
  Standard result = standard;
  if (kept.nose && is_choice(standard.radius, sphere_radius(of_case.nose))) leave_to_case(result.radius);
  if (kept.speed && is_choice(standard.speed, of_case.speed)) leave_to_case(result.speed);
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
