// The nose in the table [impactor] of a case, and the table [support].

#include "input/case_tables.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "dashpad/case/case_quantity.hpp"
#include "dashpad/quantities/quantity.hpp"
#include "input/disk.hpp"
#include "input/measurement/csv_table.hpp"
#include "input/spelling.hpp"
#include "quantities/magnitude_bounds.hpp"

namespace dashpad::input {
namespace {

/// Two points or more; nothing after a fault.
std::optional<Profile> read_points(TableReader& table, const std::string& key, Profile::Of kind) {
  const TomlNode* list = table.array(key);
  if (!list) return std::nullopt;
  const bool has_radii = kind == Profile::Of::radius;
  const char* const unit = has_radii ? "m" : "m2";
  const char* const rule = has_radii ? "a point is a depth and a radius, such as [\"10 mm\", \"35 mm\"]"
                                     : "a point is a depth and an area, such as [\"10 mm\", \"40 cm2\"]";
  Profile profile{.of = kind};
  const std::size_t faults = table.faults().size();
  for (const TomlNode& node : list->children) {
    const std::string at = table.full_key(key) + node.key;
    if (const auto point = read_pair(node, at, {"m", unit}, rule, table.faults()))
      profile.points.push_back({point->front(), point->back()});
  }
  return table.faults().size() > faults ? std::nullopt : std::optional(profile);
}

std::optional<Profile> read_file(TableReader& table, const std::filesystem::path& folder,
                                 std::vector<InputFile>& files) {
  const std::optional<std::filesystem::path> file = table.file("file", folder);
  if (!file) return std::nullopt;
  std::optional<Profile> profile = table.faults().take(read_profile_csv(*file));
  if (profile) files.push_back({"the profile of the nose", *file});
  return profile;
}

Profile read_profile(TableReader& table, const std::filesystem::path& folder, std::vector<InputFile>& files) {
  const bool has_file = table.has("file"), has_radii = table.has("radii"), has_areas = table.has("areas");
  std::optional<Profile> profile;
  if (has_file + has_radii + has_areas != 1)
    table.fault(has_file    ? "file"
                : has_radii ? "radii"
                : has_areas ? "areas"
                            : "file",
                has_file || has_radii || has_areas ? "give one of file, radii and areas"
                                                   : "is missing; give a file, radii or areas");
  else if (has_file)
    profile = read_file(table, folder, files);
  else if (has_radii)
    profile = read_points(table, "radii", Profile::Of::radius);
  else
    profile = read_points(table, "areas", Profile::Of::area);
  // After a fault a cone that keeps all rules, so that nothing else is said of the points.
  Profile result = std::move(profile).value_or(Profile{.points = {{0, 0}, {1, 1}}});
  result.scale = read_parameters<Profile>(table).scale;
  return result;
}

constexpr std::size_t max_points = 10'000;

Support read_linear(TableReader& table) {
  const double stiffness = table.quantity("stiffness", "N/m");
  if (stiffness > 0) return Support::linear(stiffness);
  if (stiffness <= 0) table.fault("stiffness", "must be more than 0");
  return Support::rigid();
}

/// Reports a coordinate that does not exceed that of the point before.
bool increases(double from, double to, const TomlNode& node, const std::string& key, std::string_view name,
               FaultList& faults) {
  if (to <= from)
    faults.add(node, key,
               fmt::format("the {} must be more than {}", name, from > 0 ? "that of the point before" : "0"));
  return to > from;
}

Support read_curve(TableReader& table) {
  const TomlNode* points = table.array("points");
  if (!points) return Support::rigid();
  if (points->children.empty() || points->children.size() > max_points) {
    table.fault("points", fmt::format("must have between 1 and {} points", max_points));
    return Support::rigid();
  }
  bool good = true;
  Support::Point before;
  std::vector<Support::Point> curve;
  for (const TomlNode& node : points->children) {
    const std::string key = table.full_key("points") + node.key;
    const auto pair =
        read_pair(node, key, {"m", "N"},
                  "a point is a deflection and a force, such as [\"0.1 in\", \"100 lbf\"]", table.faults());
    if (!pair) {
      good = false;
      continue;
    }
    const Support::Point point{pair->front(), pair->back()};
    good &=
        increases(before.deflection, point.deflection, node.children[0], key, "deflection", table.faults());
    good &= increases(before.force, point.force, node.children[1], key, "force", table.faults());
    curve.push_back(point);
    before = point;
  }
  return good ? Support::through(curve) : Support::rigid();
}

constexpr std::size_t longest_setting = 1000;

/// Of which a material takes the place.
constexpr std::array of_the_case{"law", "parameters", "curve", "rate", "unloading", "uncertainty"};

/// Takes away what cannot stand beside an entry `name` of `table`, which is called `path`.
void make_room(TomlNode& table, std::string_view path, std::string_view name) {
  const auto erase = [&](std::string_view key) {
    std::erase_if(table.children, [&](const TomlNode& toml_node) { return toml_node.key == key; });
  };
  if (name == "material")
    for (const char* key : of_the_case) erase(key);
  const std::string key = fmt::format("{}.{}", path, name);
  for (const OtherWay& way : other_ways())
    if (key == way.key || key == way.instead_of) {
      const std::string_view other = key == way.key ? way.instead_of : way.key;
      erase(other.substr(other.find('.') + 1));
    }
}

std::vector<std::string> parts_of(std::string_view key) {
  std::vector<std::string> parts;
  while (!key.empty()) parts.emplace_back(take_key_part(key));
  return parts;
}

/// Whether the table above the last two parts of a key names a card, which then holds the number.
bool is_of_card(const TomlNode& above, std::string_view table) {
  return above.child("material") != nullptr && (table == "parameters" || table == "curve" || table == "rate");
}

enum class Put { done, waits_for_case, refused };

/// Puts a value at the end of a path, or says what `rule` the key breaks.
Put put(TomlNode& root, const std::vector<std::string>& path, TomlNode value, std::string& rule) {
  const auto refuse = [&rule](std::string why) {
    rule = std::move(why);
    return Put::refused;
  };
  TomlNode* at = &root;
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    if (i + 2 == path.size() && is_of_card(*at, path[i])) return Put::waits_for_case;
    TomlNode* next = at->child(path[i]);
    if (next == nullptr && at->kind == TomlNode::Kind::array)
      return refuse(fmt::format("there are {} of them", at->children.size()));
    if (next == nullptr) {
      at->children.push_back({.kind = TomlNode::Kind::table, .line = set_by_option, .key = path[i]});
      next = &at->children.back();
    }
    if (next->kind != TomlNode::Kind::table && next->kind != TomlNode::Kind::array)
      return refuse(fmt::format("{} is a value and has no entries", path[i]));
    at = next;
  }
  make_room(*at, path.front(), path.back());
  value.key = path.back();
  if (TomlNode* there = at->child(path.back()))
    *there = std::move(value);
  else if (at->kind == TomlNode::Kind::array)
    return refuse(fmt::format("there are {} of them", at->children.size()));
  else
    at->children.push_back(std::move(value));
  return Put::done;
}

/// The material whose number a key is, as that of pad.layers[2].curve.modulus; null for other keys.
Material* material_of(std::string_view key, ImpactCase& impact) {
  const auto is_number_of = [&](std::string_view pad) {
    return key.starts_with(pad) &&
           std::ranges::any_of(std::array{".parameters.", ".curve.", ".rate."}, [&](std::string_view table) {
             return key.substr(pad.size()).starts_with(table);
           });
  };
  for (std::size_t i = 0; i < impact.pad.layers.size(); ++i)
    if (is_number_of(fmt::format("pad.layers[{}]", i + 1))) return &impact.pad.layers[i].material;
  return is_number_of("pad") ? &impact.pad.material : nullptr;
}

/// "depth [mm]", "depth (mm)" and "depth_mm" are a depth in mm.
HeaderText name_and_unit(const injury::MeasuredColumn& column) {
  const HeaderText in_brackets = split_header(column.name);
  if (!in_brackets.unit.empty()) return {lower_case(in_brackets.name), in_brackets.unit};
  const auto mark = column.name.find_last_of("_ ");
  if (mark == std::string::npos) return {lower_case(column.name), column.unit};
  return {lower_case(std::string_view(column.name).substr(0, mark)), column.name.substr(mark + 1)};
}

/// The only column of a name; nothing if there is none, and a fault if there are several or if its unit is
/// not that of the quantity.
std::optional<injury::MeasuredColumn> find_column(const CsvColumns& columns, const std::string& name,
                                                  const std::string& si_unit, std::size_t line,
                                                  MeasurementFaults& faults) {
  std::optional<injury::MeasuredColumn> found;
  for (const injury::MeasuredColumn& column : columns.all) {
    const HeaderText header = name_and_unit(column);
    if (header.name != name) continue;
    if (found) {
      faults.add(line, column.name, "", fmt::format("a second column called {}", name));
      return std::nullopt;
    }
    found = column;
    const auto [factor, rule] = header.unit.empty()
                                    ? SiValue{0, fmt::format("the {} needs a unit in the header", name)}
                                    : read_si("1 " + header.unit, si_unit);
    found->factor = factor;
    if (!rule.empty()) faults.add(line, column.name, "", rule);
  }
  return found;
}

struct ProfileColumns {
  injury::MeasuredColumn depth, size;
  Profile::Of of = Profile::Of::radius;
};

ProfileColumns choose(const CsvHeader& header, MeasurementFaults& faults) {
  constexpr const char* example = ", such as depth_mm,radius_mm";
  const CsvColumns named = named_columns(header, example, faults);
  const std::size_t line = named.names->line;
  const auto depth = find_column(named, "depth", "m", line, faults);
  const auto radius = find_column(named, "radius", "m", line, faults);
  const auto area = find_column(named, "area", "m2", line, faults);
  faults.throw_if_any();
  if (!depth) faults.refuse(line, "", "", fmt::format("a column called depth is needed{}", example));
  if (!radius && !area)
    faults.refuse(line, "", "", fmt::format("a column called radius or area is needed{}", example));
  if (radius && area) faults.refuse(line, "", "", "give a radius or an area, not both");
  return {*depth, radius ? *radius : *area, radius ? Profile::Of::radius : Profile::Of::area};
}

/// NaN after a fault.
double read_field(const CsvRow& row, const injury::MeasuredColumn& column, const std::string& si_unit,
                  char separator, MeasurementFaults& faults) {
  const auto value = number_in(row, column, separator, faults);
  const std::string rule = value ? rule_of(stated_magnitudes, *value, si_unit) : "";
  if (value && rule.empty()) return *value;
  if (value) faults.add(row.line, column.name, field_in(row, column), rule);
  return std::numeric_limits<double>::quiet_NaN();
}

Profile profile_in(const std::filesystem::path& file) {
  const std::string content = read_text_file(file).value();
  MeasurementFaults faults(file.string());
  const CsvTable table = csv_table_in(content, faults);
  const ProfileColumns columns = choose(table.header, faults);

  Profile profile{.of = columns.of};
  std::vector<std::size_t> lines;
  each_row(table, faults, [&](const CsvRow& row) {
    if (profile.points.size() == Profile::max_points)
      faults.refuse(row.line, "", "", fmt::format("more than {} rows: thin them", Profile::max_points));
    const auto read = [&](const injury::MeasuredColumn& column, const char* unit) {
      return read_field(row, column, unit, table.separator, faults);
    };
    profile.points.push_back(
        {read(columns.depth, "m"), read(columns.size, columns.of == Profile::Of::radius ? "m" : "m2")});
    lines.push_back(row.line);
  });
  faults.throw_if_any();
  for (const Profile::Fault& fault : profile.faults()) {
    const bool is_row = profile.points.size() > 1;
    faults.add(is_row ? lines[fault.point] : 0, "", "", is_row ? fault.rule : "needs two rows or more");
  }
  faults.throw_if_any();
  return profile;
}

}  // namespace

Nose read_nose(TableReader& table, const std::filesystem::path& folder, std::vector<InputFile>& files) {
  const Nose shape =
      table.has("nose") ? read_alternative<Nose>(table, "nose").value_or(Sphere{}) : Nose(Sphere{});
  if (std::holds_alternative<Profile>(shape)) return read_profile(table, folder, files);
  return with_parameters(shape, table);
}

SupportEntry read_support(TableReader& table) {
  const std::size_t faults = table.faults().size();
  const std::string type = table.choice("type", {"rigid", "linear", "curve"});
  if (type.empty()) return {.is_known = false};
  Support support = type == "linear"  ? read_linear(table)
                    : type == "curve" ? read_curve(table)
                                      : Support::rigid();
  const Backing backing = read_parameters<Backing>(table);
  for (const double Backing::*mass : {&Backing::mass, &Backing::body_mass}) {
    const char* const key = mass == &Backing::mass ? "mass" : "body_mass";
    if (table.has(key) && backing.*mass == 0)
      table.fault(key, "must be more than 0; without one, leave the key out");
  }
  table.refuse_others();
  return {std::move(support), backing, table.faults().size() == faults};
}

std::vector<LaterSetting> put_settings(const std::vector<std::string>& settings, TomlNode& root,
                                       FaultList& faults) {
  std::vector<LaterSetting> later;
  for (const std::string& setting : settings) {
    const auto sign = std::min(setting.find('='), setting.size());
    const std::string key = setting.substr(0, sign);
    const std::string value = sign < setting.size() ? setting.substr(sign + 1) : "";
    if (key.empty() || value.empty() || setting.size() > longest_setting) {
      faults.add(set_by_option, "", "",
                 fmt::format("{} must be KEY=VALUE of at most {} characters, such as pad.thickness=\"30 mm\"",
                             setting.substr(0, 40), longest_setting));
      continue;
    }
    std::string rule;
    const Put way =
        key == "support.scale" ? Put::waits_for_case : put(root, parts_of(key), toml_value(value), rule);
    if (way == Put::waits_for_case) later.push_back({key, value});
    if (way == Put::refused) faults.add(set_by_option, key, value, rule);
  }
  return later;
}

void put_later(const std::vector<LaterSetting>& settings, ImpactCase& impact, FaultList& faults) {
  if (settings.empty()) return;
  const CaseQuantities quantities = quantities_of(impact);
  std::vector<std::string> keys;
  for (const CaseQuantity& quantity : quantities) keys.push_back(quantity.key);
  for (const auto& [key, value] : settings) {
    const CaseQuantity* const found = quantities.find(key);
    if (found == nullptr) {
      faults.add(set_by_option, key, value, "is no number of this case" + did_you_mean(key, keys));
      continue;
    }
    auto [number, rule] = read_stated(value, found->unit);
    if (rule.empty() && key.starts_with("support.") && number <= 0) rule = "must be more than 0";
    if (!rule.empty()) {
      faults.add(set_by_option, key, value, rule);
      continue;
    }
    found->set(impact, number);
    // The card has its name for other numbers.
    if (Material* material = material_of(key, impact))
      material->name += fmt::format(" with {} = {}", key.substr(key.rfind('.') + 1), value);
  }
  for (const Violation& violation : violations(impact))
    for (const auto& [key, value] : settings)
      if (violation.key == key) faults.add(set_by_option, key, value, violation.rule);
}

Reading<Profile> read_profile_csv(const std::filesystem::path& file) {
  return reading_of([&] { return profile_in(file); });
}

}  // namespace dashpad::input
