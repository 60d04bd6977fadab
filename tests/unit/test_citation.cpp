// The sources of results: every card and standard that comes along has one, and the formats can be read.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "dashpad/input/case_file.hpp"
#include "dashpad/input/standard_file.hpp"
#include "dashpad/output/citation.hpp"
#include "dashpad/version.hpp"
#include "output/documents/method.hpp"
#include "sample_case.hpp"
#include "shared/generated_text.hpp"

namespace dashpad::test {
namespace {

using nlohmann::json;
using output::Citation;
using output::Cited;
using testing::AllOf;
using testing::Contains;
using testing::Each;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

ImpactCase example_case(const std::string& name) {
  return input::read_case(source / "examples" / name, source / "materials").value().impact;
}

std::vector<injury::Standard> all_standards() {
  std::vector<injury::Standard> all;
  for (const auto& file : input::list_standards(source / "standards").value())
    all.push_back(input::read_standard(file).value());
  return all;
}

/// A pad with a layer of each foam.
ImpactCase case_of_all_foams() {
  ImpactCase impact = example_case("helmet-pad-10fps.toml");
  std::vector<PadLayer> layers;
  for (const auto& file : input::list_materials(source / "materials").value())
    layers.push_back({.thickness = 0.01, .material = input::read_material(file).value()});
  set_layers(impact.pad, std::move(layers));
  return impact;
}

std::vector<std::string> cited_keys(const std::vector<Citation>& citations, Cited cited) {
  std::vector<std::string> keys;
  for (const Citation& citation : citations)
    if (citation.cited == cited) keys.push_back(citation.key);
  return keys;
}

/// All foams, all standards and all that a case can take from publications.
std::vector<Citation> everything() { return output::citations_of(case_of_all_foams(), all_standards()); }

TEST(Citation, NamesTheSourceOfEveryCardAndStandard) {
  const std::vector<Citation> all = everything();
  EXPECT_EQ(cited_keys(all, Cited::foam).size(), input::list_materials(source / "materials").value().size());
  EXPECT_EQ(cited_keys(all, Cited::standard).size(), all_standards().size());
  for (const Citation& citation : all) {
    EXPECT_NE(citation.source, "not stated") << citation.key;
    if (citation.cited == Cited::foam || citation.cited == Cited::standard) {
      EXPECT_GT(citation.source.size(), 10U) << citation.key;
    }
    EXPECT_FALSE(citation.title.empty() && citation.container.empty()) << citation.key;
    EXPECT_THAT(citation.uses, Not(IsEmpty())) << citation.key;
  }
}

TEST(Citation, HasOnlyWhatTheCaseUses) {
  // Law 4 of the report on a linear support, struck by a sphere.
  const std::vector<Citation> dashboard = output::citations_of(example_case("dashboard-20mph.toml"), {});
  EXPECT_THAT(cited_keys(dashboard, Cited::foam), ElementsAre("foam-ensolite-aac-9"));
  EXPECT_THAT(cited_keys(dashboard, Cited::standard), IsEmpty());
  EXPECT_THAT(cited_keys(dashboard, Cited::method), ElementsAre("crash-padding-1986", "49-cfr-571-208"));
  EXPECT_THAT(dashboard[1].uses,
              ElementsAre("independent columns of foam below a rigid nose", "nine-parameter law"));
  EXPECT_THAT(dashboard.back().uses,
              ElementsAre("steps, events and numerical errors", "uncertainty intervals"));
  // A base curve of Avalle's, whose columns help each other.
  const std::vector<Citation> helmet = output::citations_of(example_case("helmet-pad-10fps.toml"), {});
  EXPECT_THAT(cited_keys(helmet, Cited::method),
              ElementsAre("crash-padding-1986", "avalle-2007", "49-cfr-571-208"));
  EXPECT_THAT(helmet.back().uses, AllOf(Contains("foam law"), Contains("effect of neighbouring columns")));
  EXPECT_THAT(helmet.back().remarks, ElementsAre(HasSubstr("sections 4, 5.1, 6.1 and 6.2")));
}

TEST(Citation, SaysThatATypedFoamHasNoSource) {
  ImpactCase impact = example_case("dashboard-20mph.toml");
  impact.pad.material = {.name = foam_of_the_case, .law = impact.pad.material.law};
  const std::vector<Citation> citations = output::citations_of(impact, {});
  EXPECT_EQ(citations.front().source, "typed in the case; no source is given");
  EXPECT_THAT(output::citations_text("a", citations), HasSubstr("typed in the case; no source is given"));
  EXPECT_THAT(output::citations_bibtex(citations), HasSubstr("typed in the case; no source is given"));
}

TEST(Citation, TellsWhatAStandardsValuesRestOn) {
  const injury::Standard standard = input::read_standard(source / "standards" / "en-1078.toml").value();
  const std::vector<Citation> citations =
      output::citations_of(example_case("helmet-pad-10fps.toml"), std::vector{standard});
  const Citation& cited = citations.at(1);
  EXPECT_EQ(cited.number, "EN 1078, with the headforms of EN 960");
  EXPECT_THAT(cited.source, testing::StartsWith("secondary: https://en.wikipedia.org/wiki/EN_1078"));
  EXPECT_THAT(cited.uses, Contains(HasSubstr("speed, limit on peak acceleration: https")));
  EXPECT_THAT(cited.remarks, Contains("Unverified: mass, radius."));
}

/// Each publication of the method is a line of the documents' list of sources.
TEST(Citation, AgreesWithTheReferencesOfTheTheory) {
  const std::string theory = text_of(source / "docs" / "theory.md");
  std::string sources = theory.substr(theory.find("## 9. Sources"));
  sources =
      std::regex_replace(std::regex_replace(sources, std::regex(R"(\*)"), ""), std::regex(R"(\s+)"), " ");
  std::vector<std::string> lines;
  for (std::size_t from = sources.find(" - "), end = 0; from != std::string::npos; from = end) {
    end = sources.find(" - ", from + 3);
    lines.push_back(sources.substr(from, end - from));
  }
  std::string program = text_of(source / "CITATION.cff");
  for (const output::Publication& each : output::publications()) {
    std::vector<std::string> facts;
    for (const std::string_view fact :
         {each.title, each.container, each.volume, each.pages, each.publisher, each.place})
      facts.emplace_back(fact);
    if (each.title.find(". Volume III") != std::string::npos)
      facts[0] = "Volume III: Impact Analysis and Model Validation";
    if (each.year > 0) facts.push_back(std::to_string(each.year));
    std::string authors(each.authors);
    for (std::size_t at = 0; at < authors.size();) {
      const std::size_t end = std::min(authors.find("; ", at), authors.size());
      facts.push_back(authors.substr(at, std::min(authors.find(',', at), end) - at));
      at = end + 2;
    }
    const auto has_all = [&](const std::string& line) {
      return std::ranges::all_of(facts,
                                 [&](const auto& fact) { return line.find(fact) != std::string::npos; });
    };
    EXPECT_TRUE(each.key == output::this_program ? has_all(program) : std::ranges::any_of(lines, has_all))
        << each.key;
  }
  EXPECT_THAT(program, HasSubstr(fmt::format("version: {}\n", version())));
  EXPECT_THAT(program, HasSubstr(fmt::format("date-released: {}-{:02}-", output::publication("dashpad").year,
                                             output::publication("dashpad").month)));
}

/// Whether the braces of a text balance, none closing before it opens.
bool is_balanced(const std::string& text) {
  int open = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '\\') {
      ++i;
      continue;
    }
    open += text[i] == '{' ? 1 : text[i] == '}' ? -1 : 0;
    if (open < 0) return false;
  }
  return open == 0;
}

TEST(Citation, IsReadableBibTeX) {
  std::vector<Citation> all = everything();
  all[0].title = "100 % {of} a_b & \\c #1 $2 ^3 ~4 }{";
  const std::string text = output::citations_bibtex(all);
  EXPECT_TRUE(is_balanced(text)) << text;
  std::set<std::string> keys;
  const std::regex begin(R"((?:^|\n)@(misc|techreport|article|book)\{([A-Za-z0-9-]+),\n)");
  for (std::sregex_iterator found(text.begin(), text.end(), begin), end; found != end; ++found)
    EXPECT_TRUE(keys.insert((*found)[2]).second) << (*found)[2];
  EXPECT_EQ(keys.size(), all.size());
  EXPECT_THAT(text, HasSubstr("author = {{Transportation Systems Center}}"));
  EXPECT_THAT(text, HasSubstr("author = {Avalle, M. and Belingardi, G. and Ibba, A.}"));
  EXPECT_THAT(text, HasSubstr("pages = {3--27}"));
  // A special character without its backslash would stop TeX.
  EXPECT_FALSE(std::regex_search(text, std::regex(R"([^\\][%&#$_])")));
}

TEST(Citation, IsReadableCslJson) {
  const std::vector<Citation> all = everything();
  const json list = json::parse(output::citations_csl_json(all));
  ASSERT_EQ(list.size(), all.size());
  const std::set<std::string> types{"article-journal", "book",     "dataset", "legislation",
                                    "report",          "software", "standard"};
  std::set<std::string> ids;
  for (const json& entry : list) {
    EXPECT_TRUE(types.contains(entry.at("type"))) << entry;
    EXPECT_TRUE(ids.insert(entry.at("id")).second) << entry;
    EXPECT_TRUE(entry.contains("title") || entry.contains("container-title")) << entry;
  }
  const json report = *std::ranges::find(list, "crash-padding-1986",
                                         [](const json& e) { return e.at("id").get<std::string>(); });
  EXPECT_EQ(report.at("author"), json::parse(R"([{"literal": "Transportation Systems Center"}])"));
  EXPECT_EQ(report.at("issued"), json::parse(R"({"date-parts": [[1986, 7]]})"));
  const json whole = json::parse(output::citations_json("a.toml", all));
  EXPECT_EQ(whole.at("sources").size(), all.size());
  EXPECT_EQ(whole.at("sources").back().at("for"), "program");
}

/// Two layers of the same card are one source; with other stresses they are two, with a key each.
TEST(Citation, HasEachFoamOnce) {
  ImpactCase impact = example_case("helmet-pad-10fps.toml");
  const PadLayer layer{.thickness = 0.01, .material = impact.pad.material};
  PadLayer stiffer = layer;
  stiffer.condition.scale = 1.5;
  set_layers(impact.pad, {layer, layer, stiffer});
  const std::vector<Citation> citations = output::citations_of(impact, {});
  EXPECT_THAT(cited_keys(citations, Cited::foam),
              ElementsAre("foam-team-wendy-hard-pu", "foam-team-wendy-hard-pu-2"));
  EXPECT_THAT(citations.at(1).remarks, Contains("The case multiplies its stresses by 1.5."));
}

}  // namespace
}  // namespace dashpad::test
