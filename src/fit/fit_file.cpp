// A fit file with its table [unknowns].

#include <algorithm>
#include <functional>
#include <iterator>
#include <map>

#include "dashpad/case/case_quantity.hpp"
#include "dashpad/fit/fit.hpp"
#include "dashpad/input/case_file.hpp"
#include "dashpad/quantities/constants.hpp"
#include "dashpad/study/study.hpp"
#include "fit/card.hpp"
#include "fit/fit_tables.hpp"
#include "input/case_tables.hpp"

namespace dashpad::fit {

using input::Presence;
using input::TableReader;
using input::TomlNode;

namespace {

/// The lines of the keys that broken rules may name.
using Lines = std::map<std::string, int>;

struct UnknownEntry {
  std::string key;
  const TomlNode* node;
};

/// "pad.curve.modulus" in quotes or as tables within tables.
void collect_unknowns(const TomlNode& table, const std::string& prefix, std::vector<UnknownEntry>& entries) {
  for (const TomlNode& child : table.children) {
    const std::string key = prefix + child.key;
    const bool holds_tables =
        child.kind == TomlNode::Kind::table && !child.children.empty() &&
        std::ranges::all_of(child.children,
                            [](const TomlNode& node) { return node.kind == TomlNode::Kind::table; }) &&
        child.child("prior") == nullptr;
    if (holds_tables)
      collect_unknowns(child, key + ".", entries);
    else
      entries.push_back({key, &child});
  }
}

void read_bounds(TableReader& table, Unknown& unknown) {
  unknown.lowest = unknown.highest = no_value;
  const TomlNode* bounds = table.array("bounds");
  if (!bounds) return;
  if (bounds->children.size() != 2) {
    table.fault("bounds", "must be two values, the lower one first, such as [\"1 kPa\", \"1 MPa\"]");
    return;
  }
  const auto bound = [&](std::size_t i) {
    return value_of(bounds->children[i], table.full_key("bounds") + bounds->children[i].key, unknown.unit,
                    table.faults());
  };
  unknown.lowest = bound(0);
  unknown.highest = bound(1);
}

Unknown read_unknown(TableReader& table, const CaseQuantity& quantity, const ImpactCase& base) {
  Unknown unknown;
  unknown.key = quantity.key;
  unknown.unit = quantity.unit;
  read_bounds(table, unknown);
  unknown.start = table.has("start") ? value_in(table, "start", unknown.unit) : quantity.get(base);
  if (auto prior = table.table("prior", Presence::optional)) {
    unknown.prior.emplace();
    unknown.prior->mean = value_in(*prior, "mean", unknown.unit);
    unknown.prior->deviation = value_or_share(*prior, "deviation", unknown.unit, unknown.prior->mean);
    prior->refuse_others();
  }
  unknown.is_logarithmic = table.has("scale") ? table.choice("scale", {"log", "linear"}) == "log"
                                              : unknown.lowest > 0 && unknown.highest > 10 * unknown.lowest;
  table.refuse_others();
  return unknown;
}

}  // namespace

ImpactCase made_up_case() {
  ImpactCase impact;
  impact.impactor.mass = 1;
  impact.impactor.nose = Sphere{.radius = 0.1};
  impact.impactor.speed = 1;
  impact.pad.thickness = 0.05;
  return impact;
}

namespace {

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
  }
  top.each_table(key, *list, read);
}

/// The pad in the file, or the case that it names. False after a fault.
bool read_base(TableReader& top, const input::Folders& folders, FitFile& into) {
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
    if (auto read = top.faults().take(input::read_case(folders.of_file / name, folders.materials))) {
      into.fit.base = std::move(read->impact);
      into.fit.options = read->options;
      into.fit.has_case = true;
      std::ranges::move(read->files, std::back_inserter(into.files));
    }
  } else if (auto table = top.table("pad")) {
    input::PadMaterial pad_material = input::read_pad_material(*table, folders);
    table->refuse_others();
    if (pad_material.card) into.files.push_back({"the material card", *pad_material.card});
    if (pad_material.material) {
      std::vector<Violation> broken = violations(*pad_material.material);
      for (Violation& violation : broken) violation.key = "pad." + violation.key;
      if (pad_material.is_in_line) top.faults().add(broken);
      into.fit.base.pad.material = *std::move(pad_material.material);
    }
  }
  return top.faults().size() == before;
}

void read_search(TableReader& top, Fit& fit) {
  auto table = top.table("fit", Presence::optional);
  if (!table) return;
  if (table->has("starts"))
    fit.starts = static_cast<int>(table->whole_number("starts", 1, 1000).value_or(fit.starts));
  if (table->has("seed"))
    fit.seed =
        static_cast<std::uint64_t>(table->whole_number("seed", 0, input::largest_whole_number).value_or(1));
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

/// Impacts alone do not separate the law from the effect of neighbouring columns. Unless a case says
/// otherwise, the law takes all of it, and the card says so.
void leave_neighbours_to_law(Fit& fit) {
  if (seeks(fit, "pad.neighbours") || !rests_on_impacts_alone(fit)) return;
  for (ImpactMeasurement& impact : fit.impacts)
    if (!impact.states_neighbours) impact.impact.pad.neighbours = 0;
  if (std::ranges::none_of(fit.impacts, &ImpactMeasurement::states_neighbours)) fit.base.pad.neighbours = 0;
}

/// Reads [unknowns]. Without a sound base, names of the law are taken on trust.
void read_unknowns(TableReader& top, bool has_base, Fit& fit, Lines& lines) {
  const auto table = top.table("unknowns");
  if (!table) return;
  lines["unknowns"] = table->node().line;
  std::vector<UnknownEntry> entries;
  collect_unknowns(table->node(), "", entries);
  const CaseQuantities quantities = quantities_of(fit.base);
  for (const auto& [key, node] : entries) {
    const std::string path = "unknowns." + key;
    for (const char* part : {"", ".bounds", ".start", ".prior", ".scale"}) {
      const TomlNode* own = *part ? node->child(part + 1) : node;
      lines[path + part] = own ? own->line : node->line;
    }
    const CaseQuantity* const found = quantities.find(key);
    if (found == nullptr) {
      const bool on_trust = !has_base && (study::is_of_law(key) || key.starts_with("support."));
      if (!on_trust)
        top.faults().add(*node, path, study::rule_for_unknown(key, fit.base, study::factor_keys(fit.base)));
    } else if (node->kind != TomlNode::Kind::table) {
      top.faults().add(*node, path, "must be a table, such as {bounds = [..., ...]}");
    } else {
      TableReader reader(*node, path, top.faults());
      fit.unknowns.push_back(read_unknown(reader, *found, fit.base));
    }
  }
}

/// The temperature of a test needs a table in the card; outside its range the factor is that of its end.
void check_temperature(TableReader& table, const Material& material, MaterialMeasurement& test) {
  if (!test.temperature) return;
  const PadCondition condition{.scale = 1, .density = {}, .temperature = test.temperature};
  const std::vector<Violation> broken = violations(condition, material);
  for (const Violation& violation : broken) table.fault(violation.key, violation.rule);
  if (broken.empty())
    for (const Extrapolation& beyond : extrapolations(condition, material))
      test.remarks.push_back(beyond.text);
}

}  // namespace

input::Reading<FitFile> read_fit(const std::filesystem::path& file, const std::filesystem::path& materials) {
  const input::Reading<input::TomlFile> toml = input::read_toml(file);
  if (!toml) return toml.faults();
  const TomlNode& root = toml->root;
  input::FaultList faults(*toml);
  TableReader top(root, "", faults);
  const input::Folders folders{file.parent_path(), materials};
  FitFile result;
  result.files.push_back({"the fit file", file});
  Fit& fit = result.fit;
  Lines lines;
  fit.title = top.text("title", Presence::optional);
  const bool has_base = read_base(top, folders, result);
  const std::vector<input::InputFile> of_base(result.files.begin() + 1, result.files.end());
  read_unknowns(top, has_base, fit, lines);
  read_each(top, "tests", lines, [&](TableReader& table) {
    fit.tests.push_back(read_test(table, folders, result.files));
    if (has_base) check_temperature(table, fit.base.pad.material, fit.tests.back());
  });
  read_each(top, "impacts", lines,
            [&](TableReader& table) { read_impacts(table, folders, result.files, fit); });
  read_search(top, fit);
  leave_neighbours_to_law(fit);
  top.refuse_others();
  if (has_base) fit.recoil_is_stated = states_recoil(root, of_base);
  if (faults.size() == 0) seek_recoil(fit);
  // Rules between entries are checked only if each entry is sound.
  if (faults.size() == 0) add_broken_rules(violations(fit), root, lines, faults);
  return faults.reading(std::move(result));
}

}  // namespace dashpad::fit
