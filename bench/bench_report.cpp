/// Raw results as people look at them: stills, one page, and the tables of README.md.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "readme_tables.hpp"
#include "report.hpp"

namespace dashpad::bench {

std::string facts_text(const RawResults& results) {
  std::string text;
  for (const char* key : {"measured", "cpu", "load", "commit", "compiler"})
    for (const auto& [name, value] : results.facts())
      if (name == key) text += fmt::format("{}{}: {}", text.empty() ? "" : "; ", key, value);
  return text;
}

namespace {

namespace fs = std::filesystem;

std::string read(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  if (!stream) throw std::runtime_error("cannot read " + file.string());
  return text.str();
}

void write(const fs::path& file, const std::string& bytes) {
  std::ofstream stream(file, std::ios::binary);
  stream << bytes;
  stream.close();
  if (!stream) throw std::runtime_error("cannot write " + file.string());
}

/// By name: the tables of all chapters, and the facts of their measurements.
std::map<std::string, std::string> blocks_of(const std::vector<Chapter>& chapters) {
  std::map<std::string, std::string> blocks;
  for (const Chapter& chapter : chapters)
    for (std::size_t i = 0; i < chapter.table_names.size(); ++i)
      blocks[chapter.table_names[i]] = markdown(chapter.section.tables[i]);
  blocks["work-precision-facts"] = chapters.at(0).section.paragraphs.at(0) + ".\n";
  blocks["study-facts"] = chapters.at(1).section.paragraphs.at(0) + ".\n";
  return blocks;
}

void draw(const std::vector<Chapter>& chapters, const fs::path& folder) {
  output::Document page{
      .title = "Dashpad's benchmarks",
      .summary = {"Work against precision beside other solvers, and what studies cost. bench/README.md "
                  "says how it was measured."}};
  for (const Chapter& chapter : chapters) {
    page.sections.push_back(chapter.section);
    for (std::size_t i = 0; i < chapter.figure_names.size(); ++i)
      write(folder / (chapter.figure_names[i] + ".png"),
            output::picture(chapter.section.figures[i].plot, output::PictureFormat::png));
  }
  write(folder / "benchmarks.html", output::to_html(page));
}

int report(int count, char** arguments) {
  fs::path results, pictures, readme;
  bool check = false;
  CLI::App app{"Stills, page and tables from raw results"};
  app.add_option("RESULTS", results, "Folder with work-precision.csv and study.csv")->required();
  app.add_option("--pictures", pictures, "Folder for the stills and the page");
  app.add_option("--readme", readme, "Text whose tables are brought up to date");
  app.add_flag("--check", check, "Only say whether the tables of --readme are those of the results");
  CLI11_PARSE(app, count, arguments);
  const std::vector<Chapter> chapters{work_precision_chapter(RawResults(results / "work-precision.csv")),
                                      study_chapter(RawResults(results / "study.csv"))};
  if (!pictures.empty()) draw(chapters, pictures);
  if (readme.empty()) return 0;
  const std::string text = read(readme), fresh = with_blocks(text, blocks_of(chapters));
  if (check && fresh != text)
    throw std::runtime_error(readme.string() +
                             " does not say what the raw results say: ./do bench report "
                             "bench/results --readme bench/README.md");
  if (!check) write(readme, fresh);
  return 0;
}

}  // namespace
}  // namespace dashpad::bench

int main(int count, char** arguments) {
  try {
    return dashpad::bench::report(count, arguments);
  } catch (const std::exception& error) {
    fmt::print(stderr, "bench_report: {}\n", error.what());
    return 1;
  }
}
