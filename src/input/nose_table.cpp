#include "input/nose_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>

#include "input/disk.hpp"
#include "input/parameter_table.hpp"
#include "input/profile_csv.hpp"

namespace dashpad::input {
namespace {

/// Two points or more; nothing after a fault.
std::optional<Profile> read_points(TableReader& table, const std::string& key, Profile::Of of) {
  const TomlNode* list = table.array(key);
  if (!list) return std::nullopt;
  const char* const unit = of == Profile::Of::radius ? "m" : "m2";
  Profile profile{.of = of};
  const std::size_t faults = table.faults().size();
  for (const TomlNode& node : list->children) {
    const std::string at = table.full_key(key) + node.key;
    if (node.kind != TomlNode::Kind::array || node.children.size() != 2)
      table.faults().add(node, at,
                         of == Profile::Of::radius
                             ? "a point is a depth and a radius, such as [\"10 mm\", \"35 mm\"]"
                             : "a point is a depth and an area, such as [\"10 mm\", \"40 cm2\"]");
    else
      profile.points.push_back({read_quantity(node.children[0], at, "m", table.faults()),
                                read_quantity(node.children[1], at, unit, table.faults())});
  }
  return table.faults().size() > faults ? std::nullopt : std::optional(profile);
}

std::optional<Profile> read_file(TableReader& table, const std::filesystem::path& folder,
                                 std::vector<InputFile>& files) {
  const std::string name = table.text("file");
  if (name.empty()) return std::nullopt;
  if (std::ranges::any_of(name, [](char c) { return static_cast<unsigned char>(c) < ' '; })) {
    table.fault("file", "the path holds a control character");
    return std::nullopt;
  }
  const std::filesystem::path file = folder / name;
  if (!is_there(file)) {
    table.fault("file", "no such file: " + file.string());
    return std::nullopt;
  }
  std::optional<Profile> profile = table.faults().take(read_profile_csv(file));
  if (profile) files.push_back({"the profile of the nose", file});
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

}  // namespace

Nose read_nose(TableReader& table, const std::filesystem::path& folder, std::vector<InputFile>& files) {
  const Nose shape =
      table.has("nose") ? read_alternative<Nose>(table, "nose").value_or(Sphere{}) : Nose(Sphere{});
  if (std::holds_alternative<Profile>(shape)) return read_profile(table, folder, files);
  return with_parameters(shape, table);
}

}  // namespace dashpad::input
