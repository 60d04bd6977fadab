// The nose in the table [impactor] of a case, and the table [support].

#include "input/case_tables.hpp"

#include <optional>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "input/disk.hpp"
#include "input/table_reader.hpp"

namespace dashpad::input {
namespace {

/// Reads a list of points; absent after a fault.
std::optional<Profile> read_points(TableReader& table, const std::string& key, Profile::Of kind) {
  const TomlNode* list = table.array(key);
  if (!list) return std::nullopt;
  const bool has_radii = kind == Profile::Of::radius;
  const char* const unit = has_radii ? "m" : "m2";
  const char* const rule = has_radii ? "must be a depth and a radius, such as [\"10 mm\", \"35 mm\"]"
                                     : "must be a depth and an area, such as [\"10 mm\", \"40 cm2\"]";
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
                has_file || has_radii || has_areas ? "give only one of file, radii and areas"
                                                   : "is missing; give a file, radii or areas");
  else if (has_file)
    profile = read_file(table, folder, files);
  else if (has_radii)
    profile = read_points(table, "radii", Profile::Of::radius);
  else
    profile = read_points(table, "areas", Profile::Of::area);
  // After a fault, a valid cone avoids further faults of the points.
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
               fmt::format("the {} must be more than {}", name, from > 0 ? "the previous one" : "0"));
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
                  "must be a deflection and a force, such as [\"0.1 in\", \"100 lbf\"]", table.faults());
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
  const auto backing = read_parameters<Backing>(table);
  table.refuse_others();
  return {std::move(support), backing, table.faults().size() == faults};
}

}  // namespace dashpad::input
