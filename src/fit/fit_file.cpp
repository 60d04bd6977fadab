#include "dashpad/fit/fit_file.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

#include <fmt/format.h>

#include "dashpad/impact/case_quantity.hpp"
#include "dashpad/input/case_file.hpp"
#include "dashpad/input/measurement/stress_strain_csv.hpp"
#include "dashpad/study/application.hpp"
#include "input/pad_table.hpp"
#include "input/special_numbers.hpp"
#include "input/spelling.hpp"
#include "input/table_reader.hpp"

namespace dashpad::fit {

namespace {

using input::Presence;
using input::TableReader;
using input::TomlNode;

struct FitFolders {
  std::filesystem::path of_fit;
  std::filesystem::path materials;
};

/// Where what a broken rule is about stands, by its key.
using Lines = std::map<std::string, int>;

/// An impact of which only the material matters.
ImpactCase made_up_case() {
  ImpactCase impact;
  impact.impactor.mass = 1;
  impact.impactor.nose = Sphere{.radius = 0.1};
  impact.impactor.speed = 1;
  impact.pad.thickness = 0.05;
  return impact;
}

double value_of(const TomlNode& node, const std::string& key, const std::string& unit,
                input::FaultList& faults) {
  if (unit != "1") return read_quantity(node, key, unit, faults);
  if (node.kind == TomlNode::Kind::number && std::isfinite(node.number)) return node.number;
  faults.add(node.line, key, node.written(), "must be a plain number, without quotes and unit");
  return input::no_value;
}

double value_in(TableReader& table, const std::string& key, const std::string& unit) {
  if (!table.has(key)) {
    table.fault(key, "is missing");
    return input::no_value;
  }
  return value_of(*table.node().child(key), table.full_key(key), unit, table.faults());
}

/// A quantity, or a share in % of `whole`.
double value_or_share(TableReader& table, const std::string& key, const std::string& unit, double whole) {
  if (!table.has(key)) {
    table.fault(key, "is missing");
    return input::no_value;
  }
  const TomlNode& node = *table.node().child(key);
  if (node.kind == TomlNode::Kind::text && node.text.ends_with('%'))
    return table.quantity(key, "1") * std::abs(whole);
  return value_of(node, table.full_key(key), unit, table.faults());
}

bool flag_in(TableReader& table, const std::string& key) {
  if (!table.has(key)) return false;
  const std::string written = table.node().child(key)->written();
  if (written != "true" && written != "false") table.fault(key, "must be true or false");
  return written == "true";
}

// --- [unknowns] ---

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
                            [](const TomlNode& of) { return of.kind == TomlNode::Kind::table; }) &&
        child.child("prior") == nullptr;
    if (holds_tables)
      collect_unknowns(child, key + ".", entries);
    else
      entries.push_back({key, &child});
  }
}

/// "log" where both bounds are positive and more than a factor 10 apart, if nothing is said.
bool read_is_logarithmic(TableReader& table, const Unknown& unknown) {
  if (!table.has("scale")) return unknown.lowest > 0 && unknown.highest > 10 * unknown.lowest;
  return table.choice("scale", {"log", "linear"}) == "log";
}

void read_bounds(TableReader& table, Unknown& unknown) {
  unknown.lowest = unknown.highest = input::no_value;
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
  unknown.is_logarithmic = read_is_logarithmic(table, unknown);
  table.refuse_others();
  return unknown;
}

void read_unknowns(TableReader& top, bool has_base, Fit& fit, Lines& lines) {
  const auto table = top.table("unknowns");
  if (!table) return;
  lines["unknowns"] = table->node().line;
  std::vector<UnknownEntry> entries;
  collect_unknowns(table->node(), "", entries);
  const std::vector<CaseQuantity> quantities = quantities_of(fit.base);
  for (const auto& [key, node] : entries) {
    const std::string path = "unknowns." + key;
    for (const char* part : {"", ".bounds", ".start", ".prior", ".scale"}) {
      const TomlNode* own = *part ? node->child(part + 1) : node;
      lines[path + part] = own ? own->line : node->line;
    }
    const auto found = std::ranges::find(quantities, key, &CaseQuantity::key);
    if (found == quantities.end()) {
      const bool on_trust = !has_base && (study::is_of_law(key) || key.starts_with("support."));
      if (!on_trust)
        top.faults().add(node->line, path, node->written(), study::rule_for_unknown(key, fit.base));
    } else if (node->kind != TomlNode::Kind::table) {
      top.faults().add(node->line, path, node->written(), "must be a table: {bounds = [..., ...]}");
    } else {
      TableReader reader(*node, path, top.faults());
      fit.unknowns.push_back(read_unknown(reader, *found, fit.base));
    }
  }
}

// --- [[tests]] ---

input::StressStrainColumns read_columns(TableReader& table) {
  input::StressStrainColumns columns;
  if (auto names = table.table("columns", Presence::optional)) {
    for (const auto& [key, name] :
         {std::pair{"strain", &columns.strain}, {"stress", &columns.stress}, {"time", &columns.time}})
      if (names->has(key)) *name = names->text(key);
    names->refuse_others();
  }
  if (table.has("strain_unit")) columns.strain_unit = table.choice("strain_unit", {"fraction", "percent"});
  columns.stress_unit = table.text("stress_unit", Presence::optional);
  columns.time_unit = table.text("time_unit", Presence::optional);
  return columns;
}

void read_range(TableReader& table, MaterialMeasurement& test) {
  if (!table.has("range")) return;
  const TomlNode* range = table.array("range");
  if (!range) return;
  const bool sound =
      range->children.size() == 2 &&
      std::ranges::all_of(range->children,
                          [](const TomlNode& of) { return of.kind == TomlNode::Kind::number; }) &&
      range->children[0].number < range->children[1].number && range->children[0].number >= 0 &&
      range->children[1].number <= 1;
  if (!sound) {
    table.fault("range", "must be two strains from 0 to 1, the lower one first, such as [0, 0.5]");
    return;
  }
  test.lowest_strain = range->children[0].number;
  test.highest_strain = range->children[1].number;
}

/// Times of strains that go on at one rate, up or down.
std::vector<double> times_at(double rate, const std::vector<double>& strain) {
  std::vector<double> times{0};
  for (std::size_t i = 1; i < strain.size(); ++i)
    times.push_back(times.back() + std::abs(strain[i] - strain[i - 1]) / rate);
  return times;
}

MaterialMeasurement read_test(TableReader& table, const FitFolders& folders,
                              std::vector<input::InputFile>& files) {
  MaterialMeasurement test;
  test.file = table.text("file");
  const input::StressStrainColumns columns = read_columns(table);
  std::optional<double> rate;
  if (table.has("rate")) {
    rate = table.quantity("rate", "1/s");
    if (*rate <= 0) table.fault("rate", "must be more than 0; up or down is seen from the strains");
  }
  if (rate && !columns.time.empty()) table.fault("rate", "give a rate or a column of times, not both");
  if (!rate && columns.time.empty())
    table.fault("rate",
                "is missing; say how fast the test was, such as \"0.01 1/s\", or name a column of "
                "times: columns = {time = \"time\"}");
  read_range(table, test);
  test.has_offset = flag_in(table, "offset");
  test.is_held_out = flag_in(table, "hold_out");
  if (test.has_offset && test.is_held_out)
    table.fault("offset", "cannot be found from a test that is held out");
  if (!test.file.empty()) {
    try {
      const std::filesystem::path file = folders.of_fit / test.file;
      files.push_back({"the measurements", file});
      input::StressStrainTable read = input::read_stress_strain_csv(file, columns);
      test.strain = std::move(read.strain);
      test.stress = std::move(read.stress);
      test.time = std::move(read.time);
      if (rate && *rate > 0) test.time = times_at(*rate, test.strain);
    } catch (const input::InputError& error) {
      table.faults().add(error.faults());
    }
  }
  if (table.has("noise")) {
    double largest = input::no_value;
    for (std::size_t i = 0; i < test.stress.size(); ++i)
      if (counts(test, i) && !(test.stress[i] <= largest)) largest = test.stress[i];
    test.noise = value_or_share(table, "noise", "Pa", largest);
  }
  table.refuse_others();
  return test;
}

// --- [[impacts]] ---

/// Of an acceleration, g is standard gravity.
double figure_value(TableReader& table, const std::string& key, const ImpactFigureName& name) {
  if (name.figure == ImpactFigure::peak_acceleration && table.has(key)) {
    const TomlNode& node = *table.node().child(key);
    if (node.kind == TomlNode::Kind::text && node.text.ends_with(" g"))
      return value_of({.kind = node.kind,
                       .line = node.line,
                       .key = node.key,
                       .text = node.text.substr(0, node.text.size() - 2) + " gravity",
                       .number = 0,
                       .children = {}},
                      table.full_key(key), "m/s2", table.faults());
  }
  return value_in(table, key, name.unit);
}

MeasuredFigure read_figure(TableReader& table, const ImpactFigureName& name) {
  MeasuredFigure figure{name.figure, 0, 0};
  figure.value = figure_value(table, "value", name);
  const TomlNode* deviation = table.node().child("deviation");
  figure.deviation = deviation != nullptr && deviation->text.ends_with('%')
                         ? value_or_share(table, "deviation", name.unit, figure.value)
                         : figure_value(table, "deviation", name);
  table.refuse_others();
  return figure;
}

ImpactMeasurement read_impact(TableReader& table, const FitFolders& folders,
                              std::vector<input::InputFile>& files) {
  ImpactMeasurement impact;
  impact.file = table.text("case");
  if (!impact.file.empty()) {
    try {
      input::CaseFile read = input::read_case(folders.of_fit / impact.file, folders.materials);
      impact.impact = std::move(read.impact);
      impact.options = read.options;
      std::ranges::move(read.files, std::back_inserter(files));
    } catch (const input::InputError& error) {
      table.faults().add(error.faults());
    }
  }
  for (const ImpactFigureName& name : impact_figure_names())
    if (auto figure = table.table(name.key, Presence::optional))
      impact.figures.push_back(read_figure(*figure, name));
  impact.is_held_out = flag_in(table, "hold_out");
  table.refuse_others();
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
      top.faults().add(entry.line, path, entry.written(), "must be a table: [[" + key + "]]");
      continue;
    }
    TableReader reader(entry, path, top.faults());
    read(reader);
  }
}

// --- The whole ---

/// The pad in the file, or the case that it names. False after a fault.
bool read_base(TableReader& top, const TomlNode& root, const FitFolders& folders, FitFile& into) {
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
    try {
      input::CaseFile read = input::read_case(folders.of_fit / name, folders.materials);
      into.fit.base = std::move(read.impact);
      into.fit.has_case = true;
      std::ranges::move(read.files, std::back_inserter(into.files));
    } catch (const input::InputError& error) {
      top.faults().add(error.faults());
    }
  } else if (auto table = top.table("pad")) {
    input::PadMaterial of = input::read_pad_material(*table, folders.of_fit, folders.materials);
    table->refuse_others();
    if (of.card) into.files.push_back({"the material card", *of.card});
    if (of.material) {
      std::vector<Violation> broken = violations(*of.material);
      for (Violation& violation : broken) violation.key = "pad." + violation.key;
      if (of.is_in_line) top.faults().add(broken, root);
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
  fit.seed = static_cast<std::uint64_t>(whole("seed", 0, 9007199254740992.0, 1));
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

}  // namespace

FitFile read_fit(const std::filesystem::path& file, const std::filesystem::path& materials) {
  const TomlNode root = input::read_toml(file);
  input::FaultList faults(file.string());
  TableReader top(root, "", faults);
  const FitFolders folders{file.parent_path(), materials};
  FitFile result;
  result.files.push_back({"the fit file", file});
  Fit& fit = result.fit;
  Lines lines;
  fit.title = top.text("title", Presence::optional);
  const bool has_base = read_base(top, root, folders, result);
  read_unknowns(top, has_base, fit, lines);
  read_each(top, "tests", lines,
            [&](TableReader& table) { fit.tests.push_back(read_test(table, folders, result.files)); });
  read_each(top, "impacts", lines,
            [&](TableReader& table) { fit.impacts.push_back(read_impact(table, folders, result.files)); });
  read_search(top, fit);
  top.refuse_others();
  // What follows from several entries is judged where each is sound.
  if (faults.size() == 0) add_broken_rules(violations(fit), root, lines, faults);
  faults.throw_if_any();
  return result;
}

}  // namespace dashpad::fit
