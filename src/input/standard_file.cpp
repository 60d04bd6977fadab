#include "dashpad/input/standard_file.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "input/disk.hpp"
#include "input/spelling.hpp"
#include "input/table_reader.hpp"

namespace dashpad::input {

namespace fs = std::filesystem;

namespace {

/// SourceKind::none after a fault.
injury::SourceKind read_kind(TableReader& table) {
  constexpr injury::SourceKind all[]{injury::SourceKind::own_text, injury::SourceKind::secondary,
                                     injury::SourceKind::none};
  std::vector<std::string> names;
  for (const injury::SourceKind kind : all) names.push_back(to_string(kind));
  const auto found = std::ranges::find(names, table.choice("kind", names));
  return found == names.end() ? injury::SourceKind::none : all[found - names.begin()];
}

injury::Origin read_origin(TableReader& table) {
  injury::Origin origin{.source = table.text("source"),
                        .kind = read_kind(table),
                        .verified = table.yes_or_no("verified"),
                        .note = table.text("note", Presence::optional)};
  const TomlNode* kind = table.node().child("kind");
  if (origin.verified && kind && kind->text == to_string(injury::SourceKind::none))
    table.fault("verified", "cannot be true without a source in which the value was read (see kind)");
  return origin;
}

/// Requires a quantity to be more than 0; NaN already has a fault.
double positive(TableReader& table, const std::string& key, double value) {
  if (value <= 0) table.fault(key, "must be more than 0");
  return value;
}

/// Requires a computed number to be finite.
double finite(TableReader& table, const std::string& key, double value) {
  if (std::isinf(value)) table.fault(key, "the number is too large to compute with");
  return value;
}

/// Absent if the standard leaves the value to the case. Only speeds have a `drop_height`.
std::optional<double> read_number(TableReader& table, const std::string& si_unit,
                                  std::optional<double>& drop_height) {
  const bool is_speed = si_unit == "m/s";
  const bool has_value = table.has("value");
  const bool has_height = is_speed && table.has("drop_height");
  const bool from_case = table.flag("from_case");
  if (has_value + has_height + from_case != 1)
    table.fault("value", is_speed ? "give exactly one of value, drop_height and from_case = true"
                                  : "give either value or from_case = true");
  if (has_value) return positive(table, "value", table.quantity("value", si_unit));
  if (!has_height) return std::nullopt;
  drop_height = positive(table, "drop_height", table.quantity("drop_height", "m"));
  return finite(table, "drop_height", injury::speed_after_fall(*drop_height));
}

injury::StandardValue read_value(TableReader table, const std::string& si_unit) {
  injury::StandardValue value;
  value.value = read_number(table, si_unit, value.drop_height);
  value.origin = read_origin(table);
  table.refuse_others();
  return value;
}

std::optional<injury::StandardValue> read_value(TableReader& parent, const std::string& key,
                                                const std::string& si_unit, Presence presence) {
  const auto table = parent.table(key, presence);
  return table ? std::optional{read_value(*table, si_unit)} : std::nullopt;
}

/// Null after a fault.
const ResultQuantity* read_metric(TableReader& table) {
  std::vector<std::string> keys;
  for (const ResultQuantity* const quantity : injury::limitable_quantities())
    keys.emplace_back(quantity->key);
  return find_result_quantity(table.choice("metric", keys));
}

/// Accelerations are plain numbers in g, since "g" in files is a gram.
double read_acceleration(TableReader& table, const std::string& key) {
  return finite(table, key, standard_gravity * positive(table, key, table.number(key)));
}

double read_limit(TableReader& table, const ResultQuantity& result_quantity) {
  const std::string unit = result_quantity.si_unit;
  if (unit == "m/s2") return read_acceleration(table, "limit_g");
  return positive(table, "limit", unit == "1" ? table.number("limit") : table.quantity("limit", unit));
}

injury::Criterion read_criterion(TableReader& table) {
  injury::Criterion criterion;
  if (const ResultQuantity* const quantity = read_metric(table)) {
    criterion.quantity = quantity;
    criterion.limit = read_limit(table, *quantity);
    if (criterion.has_level()) criterion.level = read_acceleration(table, "level_g");
  } else {
    for (const char* key : {"limit", "limit_g", "level_g"}) table.has(key);  // marks them as known
  }
  criterion.strict = table.flag("strict");
  criterion.description = table.text("description");
  criterion.origin = read_origin(table);
  table.refuse_others();
  return criterion;
}

std::vector<injury::Criterion> read_criteria(TableReader& top) {
  std::vector<injury::Criterion> criteria;
  const TomlNode* array = top.array("criteria");
  if (!array) return criteria;
  if (array->children.empty()) top.fault("criteria", "must have at least one criterion");
  top.each_table("criteria", *array,
                 [&](TableReader& criterion) { criteria.push_back(read_criterion(criterion)); });
  return criteria;
}

/// Numbers of drops: whole, increasing, from 1 to 20; empty after a fault.
std::vector<int> read_counted(TableReader& table) {
  const auto read = read_numbers(table, "counted");
  std::vector<int> counted;
  if (!read || std::ranges::any_of(*read, [](double value) { return std::isnan(value); })) return counted;
  for (const double value : *read) {
    const int number = value >= 1 && value <= 20 ? static_cast<int>(value) : 0;
    if (number != value || (!counted.empty() && number <= counted.back())) {
      table.fault("counted", "must be increasing numbers of drops, such as [2, 3], from 1 to 20");
      return {};
    }
    counted.push_back(number);
  }
  if (counted.empty()) table.fault("counted", "must have at least one number");
  return counted;
}

std::optional<injury::DropSeries> read_drop_series(TableReader& top) {
  auto table = top.table("drop_series", Presence::optional);
  if (!table) return std::nullopt;
  injury::DropSeries series{.counted = read_counted(*table),
                            .step = positive(*table, "step", table->quantity("step", "m")),
                            .origin = read_origin(*table)};
  table->refuse_others();
  return series;
}

/// Names need no quotes on a command line and have no colon, which separates variants.
bool is_variant_name(const std::string& name) {
  return !name.empty() && std::ranges::all_of(name, [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-' || c == '.';
  });
}

injury::StandardVariant read_variant(TableReader table, const std::string& name) {
  injury::StandardVariant variant;
  variant.name = name;
  variant.title = table.text("title");
  variant.mass = read_value(table, "mass", "kg", Presence::optional);
  variant.radius = read_value(table, "radius", "m", Presence::optional);
  variant.speed = read_value(table, "speed", "m/s", Presence::optional);
  table.refuse_others();
  if (!variant.mass && !variant.radius && !variant.speed)
    table.faults().add(table.node().line, table.full_key("mass"), "",
                       "a variant must replace mass, radius or speed");
  return variant;
}

std::vector<injury::StandardVariant> read_variants(TableReader& top) {
  std::vector<injury::StandardVariant> variants;
  auto table = top.table("variants", Presence::optional);
  if (!table) return variants;
  for (const TomlNode& entry : table->node().children) {
    if (!is_variant_name(entry.key))
      table->fault(entry.key, "the name of a variant may contain only lower-case letters, digits, - and .");
    else if (const auto variant = table->table(entry.key))
      variants.push_back(read_variant(*variant, entry.key));
  }
  return variants;
}

}  // namespace

Reading<injury::Standard> read_standard(const fs::path& file) {
  const Reading<TomlFile> toml = read_toml(file);
  if (!toml) return toml.faults();
  FaultList faults(*toml);
  TableReader top(toml->root, "", faults);
  injury::Standard standard;
  standard.name = file.stem().string();
  standard.title = top.text("title");
  standard.article = top.text("article", Presence::optional);
  standard.source = top.text("source");
  standard.source_kind = read_kind(top);
  standard.note = top.text("note", Presence::optional);
  standard.mass = read_value(top, "mass", "kg", Presence::required).value_or(injury::StandardValue{});
  standard.radius = read_value(top, "radius", "m", Presence::required).value_or(injury::StandardValue{});
  standard.speed = read_value(top, "speed", "m/s", Presence::required).value_or(injury::StandardValue{});
  standard.criteria = read_criteria(top);
  standard.drop_series = read_drop_series(top);
  standard.variants = read_variants(top);
  top.refuse_others();
  return faults.reading(std::move(standard));
}

Reading<std::vector<fs::path>> list_standards(const fs::path& folder) {
  return toml_files(folder, "standards");
}

StandardChoice standard_choice(const std::string& text) {
  const std::string ending = ".toml";
  const auto file_end = text.find(ending + ":");
  auto end = file_end != std::string::npos ? file_end + ending.size()
             : text.ends_with(ending)      ? text.size()
                                           : std::min(text.find(':'), text.size());
  StandardChoice choice{text.substr(0, end), {}};
  while (end < text.size()) {
    const auto next = std::min(text.find(':', end + 1), text.size());
    choice.variants.push_back(text.substr(end + 1, next - end - 1));
    end = next;
  }
  return choice;
}

Reading<fs::path> find_standard(const std::string& name, const fs::path& folder) {
  if (name.ends_with(".toml")) return fs::path(name);
  const Reading<std::vector<fs::path>> files = list_standards(folder);
  if (!files) return files.faults();
  const std::vector<std::string> names = names_of(*files);
  const auto found = std::ranges::find(names, name);
  if (found != names.end()) return (*files)[static_cast<std::size_t>(found - names.begin())];
  if (name.find('/') != std::string::npos)
    return fault_of_file(name, "no such standard: a path must end in .toml");
  return fault_of_file(name, no_such("standard", name, folder, *files));
}

}  // namespace dashpad::input
