// One name a quantity: text, JSON, CSV, page, studies and standards speak the words of the table of results,
// and no others.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <regex>
#include <set>
#include <sstream>

#include "command.hpp"
#include "dashpad/injury/standard.hpp"
#include "dashpad/result/result_quantity.hpp"
#include "dashpad/study/responses.hpp"

namespace dashpad::test {
namespace {

using nlohmann::json;
using testing::Contains;
using testing::IsEmpty;
using testing::IsSupersetOf;
using testing::UnorderedElementsAreArray;
using Names = std::vector<std::string>;

/// What an output says, and what of it the table does not know.
struct Found {
  Names known;    ///< keys of the table
  Names foreign;  ///< as they stand
};

const ResultQuantity* titled(const std::string& title) {
  const auto& all = result_quantities();
  const auto found = std::ranges::find_if(all, [&](const auto& given) { return title == given.title; });
  return found == all.end() ? nullptr : &*found;
}

void note(Found& found, const ResultQuantity* quantity, const std::string& word) {
  if (quantity != nullptr)
    found.known.emplace_back(quantity->key);
  else
    found.foreign.push_back(word);
}

// --- JSON ---

/// What stands inside a quantity, or beside its value.
const std::set<std::string> attributes{
    "time_s",  "velocity_m_per_s", "begin_s",          "end_s",           "error", "lower_bound",
    "level_g", "longest_s",        "longest_window_s", "difference_share"};

/// What a part of a quantity that carries its unit may be called.
const Names values{"value", "measured", "computed", "difference"};

/// The quantity whose key this is: with its unit where a number follows, without where a number follows that
/// is an error, and where its parts do.
const ResultQuantity* keyed(const std::string& key, const json& value, bool of_errors) {
  for (const ResultQuantity& result_quantity : result_quantities()) {
    const bool is_plain =
        key == result_quantity.key && (of_errors || value.is_structured() || value.is_null());
    if (is_plain || (!of_errors && !value.is_array() && key == key_with_unit(result_quantity)))
      return &result_quantity;
  }
  return nullptr;
}

void walk_parts(const ResultQuantity& result_quantity, const json& value, Found& found) {
  const std::string unit = scaled_unit(result_quantity.si_unit, plain_si()).unit;
  const std::string own = name_with_unit("value", unit);
  std::set<std::string> carriers{"value"};
  for (const std::string& name : values) carriers.insert(name_with_unit(name, unit));
  for (const auto& [key, part] : value.items()) {
    if (value.is_array())
      walk_parts(result_quantity, part, found);
    else if (value.is_object() && !carriers.contains(key) && !attributes.contains(key))
      found.foreign.push_back(std::string{result_quantity.key} + "." + key);
    if (key == "value" && own != "value" && !value.contains("lower_bound"))
      found.foreign.push_back(std::string{result_quantity.key} + ".value without its unit");
  }
}

/// The containers are gone into, what is passed over is none of a result.
Found walk(const json& object, const std::set<std::string>& containers, const std::set<std::string>& passed,
           bool of_errors = false) {
  Found found;
  for (const auto& [key, value] : object.items()) {
    if (passed.contains(key) || key == "format") continue;
    if (containers.contains(key)) {
      const Found inside = walk(value, containers, passed, key == "errors");
      found.known.insert(found.known.end(), inside.known.begin(), inside.known.end());
      found.foreign.insert(found.foreign.end(), inside.foreign.begin(), inside.foreign.end());
    } else if (key == "hic_windows") {  // HIC with windows of one's own
      for (const json& entry : value) walk_parts(result_quantity("hic_unlimited"), entry, found);
    } else {
      const ResultQuantity* quantity = keyed(key, value, of_errors);
      note(found, quantity, key);
      if (quantity != nullptr && value.is_structured()) walk_parts(*quantity, value, found);
    }
  }
  return found;
}

Found walk_result(const json& result) {
  Found found =
      walk(result, {"energy", "injury", "errors"},
           {"status", "blows", "layers", "flags", "extrapolated", "extrapolated_strain", "extrapolated_rate",
            "extrapolations", "intervals", "softening_rates_per_s", "solver", "case", "program"});
  for (const json& blow : result.value("blows", json::array()))
    for (const std::string& word : walk(blow, {}, {"blow", "status", "earlier_penetration_m"}).foreign)
      found.foreign.push_back("blows." + word);
  for (const json& layer : result.value("layers", json::array()))
    for (const std::string& word :
         walk(layer, {},
              {"layer", "material", "highest_tested_strain", "time_beyond_tested_s", "time_struck_through_s"})
             .foreign)
      found.foreign.push_back("layers." + word);
  return found;
}

// --- Text ---

Names cells(const std::string& line) {
  static const std::regex gap(" {2,}");
  const std::string text = line.substr(line.find_first_not_of(' '));
  return {std::sregex_token_iterator(text.begin(), text.end(), gap, -1), std::sregex_token_iterator()};
}

/// The rows of figures: indented lines from `begin` to the next empty one. A dwell time has its level, and
/// HIC the window that was asked for.
Found rows_of(const std::string& text, const std::string& begin) {
  static const std::regex level(" above [0-9.]+ g$"), window("^HIC, window up to [0-9.]+ ms$");
  Found found;
  const auto at = text.find(begin);
  std::istringstream lines(at == std::string::npos ? "" : text.substr(at + begin.size()));
  for (std::string line; std::getline(lines, line) && !line.empty();) {
    if (!line.starts_with("  ") || line[2] == ' ') continue;  // the second line of a remark
    const std::string label = std::regex_replace(std::regex_replace(cells(line).front(), level, ""), window,
                                                 result_quantity("hic_unlimited").title);
    note(found, titled(label), label);
  }
  return found;
}

void expect_table_only(const Found& found, const Names& among, const std::string& where) {
  EXPECT_THAT(found.foreign, IsEmpty()) << where;
  EXPECT_THAT(found.known, IsSupersetOf(among)) << where;
}

// --- Tables of numbers ---

Found heading_of(const std::string& csv, const UnitSystem& units) {
  Found found;
  std::istringstream names(csv.substr(0, csv.find('\n')));
  for (std::string name; std::getline(names, name, ',');) {
    const auto& all = result_quantities();
    const auto quantity =
        std::ranges::find_if(all, [&](const auto& each) { return name == key_with_unit(each, units); });
    note(found, quantity == all.end() ? nullptr : &*quantity, name);
  }
  return found;
}

const Names of_impact{"peak_force",    "peak_acceleration", "peak_penetration",
                      "rebound_speed", "contact_end",       "energy_absorbed_fraction"};
const Names of_pulse{"peak_acceleration", "hic15", "clip_3ms", "velocity_change"};
const Names all_of_pulse{"hic15",    "hic36",          "hic_unlimited",  "hic_d",
                         "clip_3ms", "cumulative_3ms", "severity_index", "velocity_change"};

class NamesTest : public CommandTest {};

TEST_F(NamesTest, OfTheTableAreOneEach) {
  const std::string docs = read_file(DASHPAD_SOURCE_DIR "/docs/results.md");
  std::set<std::string> keys, titles;
  for (const ResultQuantity& result_quantity : result_quantities()) {
    EXPECT_TRUE(keys.insert(result_quantity.key).second) << result_quantity.key;
    EXPECT_TRUE(titles.insert(result_quantity.title).second) << result_quantity.title;
    EXPECT_FALSE(std::string{result_quantity.meaning}.empty()) << result_quantity.key;
    EXPECT_THAT(docs, testing::HasSubstr("`" + std::string{result_quantity.key} + "`"));
  }
}

TEST_F(NamesTest, OfARunAreThoseOfTheTable) {
  const Outcome run = dashpad({"run", nine, "--json", "-", "--csv", file("history.csv")});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const Found result = walk_result(json::parse(run.out));
  expect_table_only(result, all_of_pulse, "JSON");
  expect_table_only(result, of_impact, "JSON");
  EXPECT_THAT(result.known, IsSupersetOf({"bottomed", "release", "force_below_weight", "residual_energy"}));
  Found text = rows_of(run.err, "\n\n");
  expect_table_only(text, of_impact, "text");
  EXPECT_THAT(text.known, Contains("hic15"));
  const std::string all = dashpad({"run", nine, "--all"}).out;
  expect_table_only(rows_of(all, "\nThe impact:\n"), of_impact, "--all");
  expect_table_only(rows_of(all, "\nInjury metrics of this pulse:\n"), all_of_pulse, "--all");
  const Outcome series =
      dashpad({"run", DASHPAD_SOURCE_DIR "/examples/playground-three-drops.toml", "--json", "-"});
  expect_table_only(walk_result(json::parse(series.out)), of_impact, "JSON of blows");
  const Names columns{"time", "force", "acceleration", "velocity", "support_deflection", "axis_strain"};
  expect_table_only(heading_of(read_file(file("history.csv")), plain_si()), columns, "CSV");
  for (const char* units : {"us", "engineering-metric"})
    expect_table_only(
        heading_of(dashpad({"run", nine, "--csv", "-", "--units", units}).out, unit_system(units)), columns,
        units);
}

TEST_F(NamesTest, OfThePageAreThoseOfTheTable) {
  ASSERT_EQ(dashpad({"run", nine, "--report", file("page.html")}).exit_code, 0);
  const std::string page = read_file(file("page.html"));
  Found found;
  const std::string head = R"(<th scope="col">Figure</th>)", row = R"(<th scope="row">)";
  for (auto table = page.find(head); table != std::string::npos; table = page.find(head, table + 1)) {
    const auto end = page.find("</table>", table);
    for (auto at = page.find(row, table); at < end; at = page.find(row, at + 1)) {
      const auto begin = at + row.size();
      const std::string label = page.substr(begin, page.find('<', begin) - begin);
      note(found, titled(label), label);
    }
  }
  expect_table_only(found, of_impact, "page");
  expect_table_only(found, all_of_pulse, "page");
}

TEST_F(NamesTest, OfAPulseAreThoseOfTheTable) {
  ASSERT_EQ(dashpad({"run", nine, "--csv", file("run.csv")}).exit_code, 0);
  const Outcome pulse = dashpad({"pulse", file("run.csv"), "--json", "-", "--csv", file("again.csv"),
                                 "--speed", "20 mph", "--window", "22", "--dwell", "80"});
  ASSERT_EQ(pulse.exit_code, 0) << pulse.err;
  const Found found = walk(json::parse(pulse.out), {"figures", "impact"},
                           {"flags", "source", "about", "offset", "processing", "program", "speed_m_per_s",
                            "drop_height_m", "gravity_m_per_s2", "check", "uncertainty"});
  expect_table_only(found, all_of_pulse, "JSON");
  const json uncertainties = json::parse(pulse.out).at("uncertainty").at("figures");
  EXPECT_FALSE(uncertainties.empty());
  for (const auto& [key, components] : uncertainties.items()) EXPECT_THAT(found.known, Contains(key));
  EXPECT_THAT(found.known, IsSupersetOf({"restitution", "dwell_time"}));
  expect_table_only(rows_of(pulse.err, "\n\n"), of_pulse, "text");
  const std::string all = dashpad({"pulse", file("run.csv"), "--all", "--window", "22"}).out;
  expect_table_only(rows_of(all, "\nFigures:\n"), all_of_pulse, "--all");
  EXPECT_THAT(rows_of(all, "\nFigures:\n").known, Contains("dwell_time"));
  EXPECT_EQ(heading_of(read_file(file("again.csv")), plain_si()).known, (Names{"time", "acceleration"}));
}

TEST_F(NamesTest, OfAComparisonOfPulsesAreThoseOfTheTable) {
  const Outcome outcome = dashpad({"compare", examples + "helmet-pad-10fps.toml", "--pulse",
                                   examples + "pulses/synthetic-helmet-pad.csv", "--json", "-"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const Names all{"peak_acceleration", "time_to_peak", "half_peak_width",
                  "velocity_change",   "hic15",        "restitution"};
  expect_table_only(
      walk(json::parse(outcome.out), {"figures"}, {"answer", "alignment", "case", "pulse", "program"}), all,
      "JSON");
  expect_table_only(rows_of(outcome.err, "\n\n"), all, "text");
}

TEST_F(NamesTest, OfStandardsAndTheirAssessmentsAreThoseOfTheTable) {
  std::set<std::string> metric_keys, used;
  for (const ResultQuantity* const quantity : injury::limitable_quantities())
    metric_keys.insert(quantity->key);
  static const std::regex line("\nmetric = \"([^\"]*)\"");
  for (const auto& entry : fs::directory_iterator(DASHPAD_SOURCE_DIR "/standards")) {
    const std::string text = read_file(entry.path());
    for (auto at = std::sregex_iterator(text.begin(), text.end(), line); at != std::sregex_iterator(); ++at)
      used.insert((*at)[1]);
    if (text.find("metric") == std::string::npos) continue;
    const std::string name = entry.path().stem().string();
    const Outcome outcome = dashpad({"assess", nine, "--standard", name, "--json", "-"});
    const json result = json::parse(outcome.out);
    for (const json& criterion : result.at("criteria")) {
      const ResultQuantity* result_quantity = find_result_quantity(criterion.at("metric").get<std::string>());
      ASSERT_NE(result_quantity, nullptr) << criterion;
      EXPECT_EQ(criterion.at("unit"), scaled_unit(result_quantity->si_unit, plain_si()).unit);
    }
    expect_table_only(walk(result.at("figures"), {}, {}), {"peak_acceleration", "hic15", "contact_end"},
                      name);
    expect_table_only(walk_result(result.at("result")), of_impact, name);
    expect_table_only(rows_of(outcome.err, "\n\n"), {"hic36", "peak_strain"}, name);
    const std::string all = dashpad({"assess", nine, "--standard", name, "--all"}).out;
    expect_table_only(rows_of(all, "\nFigures:\n"), {"contact_end", "peak_strain"}, name);
  }
  EXPECT_THAT(metric_keys, IsSupersetOf(used));
  EXPECT_THAT(used, IsSupersetOf({"peak_acceleration", "clip_3ms", "dwell_time", "hic_d"}));
}

TEST_F(NamesTest, OfAStudyAreThoseOfTheTable) {
  Names keys, headings;
  std::string list;
  for (const ResultQuantity& kind : study::response_kinds()) {
    const ResultQuantity& of = result_quantity(kind.key);
    EXPECT_STREQ(kind.title, of.title);
    EXPECT_STREQ(kind.si_unit, of.si_unit);
    keys.emplace_back(kind.key);
    list += (list.empty() ? "\"" : ", \"") + keys.back() + "\"";
  }
  write_file(file("study.toml"), "case = \"" + nine + "\"\nresponses = [" + list +
                                     "]\n[factors.\"impactor.mass\"]\nvalues = [\"4 kg\", \"5 kg\"]\n"
                                     "[factors.\"impactor.speed\"]\nvalues = [\"5 m/s\", \"8 m/s\"]\n");
  const Outcome computed = dashpad({"study", file("study.toml"), "--out", file("s.db"), "--quiet"});
  ASSERT_EQ(computed.exit_code, 0) << computed.err;
  std::string csv = dashpad({"study", "export", file("s.db"), "--csv", "-"}).out;
  const std::string factors =
      "row,status,extrapolated,extrapolated_strain,extrapolated_rate,bottomed,error,impactor.mass_kg,"
      "impactor.speed_m_per_s,";
  ASSERT_THAT(csv, testing::StartsWith(factors));
  const Found columns = heading_of(csv.substr(factors.size()), plain_si());
  EXPECT_THAT(columns.foreign, IsEmpty());
  EXPECT_EQ(columns.known, keys);
  const Outcome summary =
      dashpad({"study", "summary", file("s.db"), "--json", "-", "--limit", "peak_acceleration > 80 g"});
  ASSERT_EQ(summary.exit_code, 0) << summary.err;
  const json answers = json::parse(summary.out);
  Names named;
  for (const json& group : answers.at("groups"))
    for (const char* part : {"distributions", "exceedances"})
      for (const json& entry : group.at(part)) {
        const ResultQuantity& of = result_quantity(entry.at("response").get<std::string>());
        EXPECT_EQ(entry.at("unit"), scaled_unit(of.si_unit, plain_si()).unit) << of.key;
        if (part == std::string{"distributions"}) named.emplace_back(of.key);
      }
  EXPECT_THAT(named, UnorderedElementsAreArray(keys));
  for (const json& curve : answers.at("cushion_curves").at("curves"))
    for (const json& point : curve.at("points"))
      EXPECT_THAT(walk(point, {}, {"static_stress_Pa"}).foreign, IsEmpty());
  // The text has them by their titles, with the unit in brackets.
  static const std::regex unit(" \\((?!d\\))[^)]*\\)$");
  const std::string document = dashpad({"study", "summary", file("s.db"), "--markdown", "-"}).out;
  std::istringstream rows(document.substr(document.find("\n| Response ") + 1));
  Found text;
  std::string row;
  std::getline(rows, row);
  for (std::getline(rows, row); std::getline(rows, row) && !row.empty();) {
    const std::string label = std::regex_replace(row.substr(2, row.find(" | ") - 2), unit, "");
    note(text, titled(label), label);
  }
  EXPECT_THAT(text.foreign, IsEmpty());
  EXPECT_EQ(text.known, keys);
}

TEST_F(NamesTest, ThatAreForeignAreNoticed) {
  const auto foreign = [](const char* text) { return walk_result(json::parse(text)).foreign; };
  EXPECT_THAT(foreign(R"({"peak_force_N": 1, "injury": {"clip_3ms": {"value_g": 1, "begin_s": 0}}})"),
              IsEmpty());
  for (const char* text :
       {R"({"peak_farce_N": 1})", R"({"peak_acceleration": 1})", R"({"peak_force_lbf": 1})",
        R"({"injury": {"clip_3ms_contiguous": {"value_g": 1}}})", R"({"errors": {"weight": 1}})",
        R"({"injury": {"clip_3ms": {"value": 1}}})", R"({"injury": {"clip_3ms": {"level": 1}}})",
        R"({"energy": {"pad_J": 1}})", R"({"hic15": {"measured_g": 1}})"})
    EXPECT_EQ(foreign(text).size(), 1U) << text;
  EXPECT_THAT(rows_of("\n\n  3 ms level   5 g\n  Peak force   2 N\n\n  x\n", "\n\n").foreign,
              testing::ElementsAre("3 ms level"));
  EXPECT_THAT(heading_of("time_s,peak_acceleration_m_s2\n", plain_si()).foreign,
              testing::ElementsAre("peak_acceleration_m_s2"));
}

}  // namespace
}  // namespace dashpad::test
