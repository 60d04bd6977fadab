#include "dashpad/injury/standard.hpp"

#include <algorithm>
#include <cmath>
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

struct MetricKey {
  Metric metric;
  const char* key;  ///< of its quantity
};

constexpr MetricKey metric_keys[]{{Metric::peak_acceleration, "peak_acceleration"},
                                  {Metric::clip_3ms, "clip_3ms"},
                                  {Metric::cumulative_3ms, "cumulative_3ms"},
                                  {Metric::dwell_time, "dwell_time"},
                                  {Metric::hic15, "hic15"},
                                  {Metric::hic36, "hic36"},
                                  {Metric::hic_unlimited, "hic_unlimited"},
                                  {Metric::hic_d, "hic_d"},
                                  {Metric::severity_index, "severity_index"}};

std::string names_of(const std::vector<StandardVariant>& variants) {
  std::string names;
  for (const StandardVariant& variant : variants) names += (names.empty() ? "" : ", ") + variant.name;
  return names;
}

const StandardVariant& find_variant(const Standard& standard, const std::string& name) {
  const auto found = std::ranges::find(standard.variants, name, &StandardVariant::name);
  if (found != standard.variants.end()) return *found;
  throw std::invalid_argument(
      standard.name + " has no variant \"" + name + "\"; " +
      (standard.variants.empty() ? "it has none" : "it has " + names_of(standard.variants)));
}

[[noreturn]] void refuse_two(const Standard& standard, const std::pair<std::string, std::string>& variants,
                             const std::string& what) {
  throw std::invalid_argument("the variants \"" + variants.first + "\" and \"" + variants.second + "\" of " +
                              standard.name + " both set the " + what);
}

void replace(StandardValue& standard, std::optional<double> by_user, std::optional<double> drop_height) {
  if (!by_user || (standard.value && !differ(*by_user, *standard.value))) return;
  standard = {.value = by_user,
              .drop_height = drop_height,
              .origin = {.source = "the user", .kind = SourceKind::none, .verified = true, .note = ""},
              .chosen_by_user = true,
              .instead = standard.value};
}

}  // namespace

std::string to_string(SourceKind kind) {
  switch (kind) {
    case SourceKind::own_text: return "own text";
    case SourceKind::secondary: return "secondary";
    case SourceKind::none: return "no source";
  }
  return "";
}

const std::vector<Metric>& metrics() {
  static const std::vector<Metric> all = [] {
    std::vector<Metric> list;
    for (const MetricKey& entry : metric_keys) list.push_back(entry.metric);
    return list;
  }();
  return all;
}

const ResultQuantity& quantity_of(Metric metric) {
  return result_quantity(std::ranges::find(metric_keys, metric, &MetricKey::metric)->key);
}

namespace {

std::string above_level(const Criterion& criterion) {
  if (criterion.metric != Metric::dwell_time) return "";
  return fmt::format(" above {:.5g} g", criterion.level / standard_gravity);
}

}  // namespace

std::string title_of(const Criterion& criterion) {
  return quantity_of(criterion.metric).title + above_level(criterion);
}

std::string limit_of(const Criterion& criterion) {
  return "limit of " + title_in_sentence(quantity_of(criterion.metric)) + above_level(criterion);
}

Standard with_variants(const Standard& standard, const std::vector<std::string>& names) {
  Standard result = standard;
  for (const std::string& name : names) {
    const StandardVariant& variant = find_variant(standard, name);
    for (const auto& [what, value, replacement] : replaceable) {
      if (!(variant.*replacement)) continue;
      for (const std::string& other : result.chosen)
        if (find_variant(standard, other).*replacement) refuse_two(standard, {other, name}, what);
      result.*value = *(variant.*replacement);
    }
    result.chosen.push_back(name);
  }
  return result;
}

Standard with_user_values(const Standard& standard, const UserValues& values) {
  Standard result = standard;
  replace(result.mass, values.mass, {});
  replace(result.radius, values.radius, {});
  replace(result.speed, values.speed, {});
  if (values.drop_height) replace(result.speed, speed_after_fall(*values.drop_height), values.drop_height);
  return result;
}

/// Units are exact to some digits of a double; nobody means less than nine. NaN is what a case does not have.
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

}  // namespace dashpad::injury
