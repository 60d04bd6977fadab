#include "dashpad/fit/fit_file.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>

#include <fmt/format.h>

#include "dashpad/input/case_file.hpp"
#include "fit/fit_tables.hpp"
#include "fit/recoil.hpp"
#include "input/pad_table.hpp"

namespace dashpad::fit {

using input::Presence;
using input::TableReader;
using input::TomlNode;

namespace {

/// An impact of which only the material matters.
ImpactCase made_up_case() {
  ImpactCase impact;
  impact.impactor.mass = 1;
  impact.impactor.nose = Sphere{.radius = 0.1};
  impact.impactor.speed = 1;
  impact.pad.thickness = 0.05;
  return impact;
}
/// Reads each table of [[key]].
void read_each(TableReader& top, const std::string& key, Lines& lines,
               const std::function<void(TableReader&)>& read) {
  if (!top.has(key)) return;
  const TomlNode* list = top.array(key);
  if (!list) return;
  for (const TomlNode& entry : list->children) {
    const std::string path = key + entry.key;
    lines[path] = entry.line;
    for (const TomlNode& child : entry.children) lines[path + "." + child.key] = child.line;
    if (entry.kind != TomlNode::Kind::table) {
      top.faults().add(entry, path, "must be a table: [[" + key + "]]");
      continue;
    }
    TableReader reader(entry, path, top.faults());
    read(reader);
  }
}
/// The pad in the file, or the case that it names. False after a fault.
bool read_base(TableReader& top, const FitFolders& folders, FitFile& into) {
  const std::size_t before = top.faults().size();
  const bool has_case = top.has("case");
  const bool has_pad = top.has("pad");
  into.fit.base = made_up_case();
  if (has_case == has_pad) {
    top.fault("pad", has_case ? "give a pad or a case, not both"
                              : "is missing; give the law with its starting values, or case = \"file.toml\"");
    return false;
  }
  if (has_case) {
    const std::string name = top.text("case");
    if (name.empty()) return false;
    if (auto read = top.faults().take(input::read_case(folders.of_fit / name, folders.materials))) {
      into.fit.base = std::move(read->impact);
      into.fit.options = read->options;
      into.fit.has_case = true;
      std::ranges::move(read->files, std::back_inserter(into.files));
    }
  } else if (auto table = top.table("pad")) {
    input::PadMaterial of = input::read_pad_material(*table, folders.of_fit, folders.materials);
    table->refuse_others();
    if (of.card) into.files.push_back({"the material card", *of.card});
    if (of.material) {
      std::vector<Violation> broken = violations(*of.material);
      for (Violation& violation : broken) violation.key = "pad." + violation.key;
      if (of.is_in_line) top.faults().add(broken);
      into.fit.base.pad.material = *std::move(of.material);
    }
  }
  return top.faults().size() == before;
}

void read_search(TableReader& top, Fit& fit) {
  auto table = top.table("fit", Presence::optional);
  if (!table) return;
  const auto whole = [&](const char* key, double lowest, double highest, double otherwise) {
    if (!table->has(key)) return otherwise;
    const double value = table->number(key);
    if (value >= lowest && value <= highest && value == std::floor(value)) return value;
    if (!std::isnan(value))
      table->fault(key, fmt::format("must be a whole number from {:.0f} to {:.0f}", lowest, highest));
    return otherwise;
  };
  fit.starts = static_cast<int>(whole("starts", 1, 1000, fit.starts));
  fit.seed = static_cast<std::uint64_t>(whole("seed", 0, 9007199254740991.0, 1));
  table->refuse_others();
}

void add_broken_rules(const std::vector<Violation>& broken, const TomlNode& root, const Lines& lines,
                      input::FaultList& faults) {
  for (const Violation& violation : broken) {
    const auto line = lines.find(violation.key);
    faults.add(line != lines.end() ? line->second : root.nearest(violation.key).line, violation.key, "",
               violation.rule);
  }
}

/// Impacts alone tell the law and what neighbouring columns do as one: unless a case says otherwise, it is
/// all in the law, and the card says so.
void leave_neighbours_to_law(Fit& fit) {
  const bool is_unknown = std::ranges::count(fit.unknowns, "pad.neighbours", &Unknown::key) > 0;
  if (is_unknown || !rests_on_impacts_alone(fit)) return;
  for (ImpactMeasurement& impact : fit.impacts)
    if (!impact.states_neighbours) impact.impact.pad.neighbours = 0;
  if (std::ranges::none_of(fit.impacts, &ImpactMeasurement::states_neighbours)) fit.base.pad.neighbours = 0;
}

}  // namespace

input::Reading<FitFile> read_fit(const std::filesystem::path& file, const std::filesystem::path& materials) {
  const input::Reading<input::TomlFile> toml = input::read_toml(file);
  if (!toml) return toml.faults();
  const TomlNode& root = toml->root;
  input::FaultList faults(*toml);
  TableReader top(root, "", faults);
  const FitFolders folders{file.parent_path(), materials};
  FitFile result;
  result.files.push_back({"the fit file", file});
  Fit& fit = result.fit;
  Lines lines;
  fit.title = top.text("title", Presence::optional);
  const bool has_base = read_base(top, folders, result);
  const std::vector<input::InputFile> of_base(result.files.begin() + 1, result.files.end());
  read_unknowns(top, has_base, fit, lines);
  read_each(top, "tests", lines,
            [&](TableReader& table) { fit.tests.push_back(read_test(table, folders, result.files)); });
  read_each(top, "impacts", lines,
            [&](TableReader& table) { fit.impacts.push_back(read_impact(table, folders, result.files)); });
  read_search(top, fit);
  leave_neighbours_to_law(fit);
  top.refuse_others();
  if (has_base) fit.recoil_is_stated = states_recoil(root, of_base);
  if (faults.size() == 0) seek_recoil(fit);
  // What follows from several entries is judged where each is sound.
  if (faults.size() == 0) add_broken_rules(violations(fit), root, lines, faults);
  return faults.reading(std::move(result));
}

}  // namespace dashpad::fit
