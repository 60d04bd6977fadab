#include "readme_tables.hpp"

#include <set>
#include <stdexcept>

namespace dashpad::bench {
namespace {

std::string line_of(const std::vector<std::string>& cells) {
  std::string line = "|";
  for (const std::string& cell : cells) line += " " + cell + " |";
  return line + "\n";
}

}  // namespace

std::string markdown(const output::Table& table) {
  std::string text = table.caption.empty() ? "" : table.caption + ":\n\n";
  text += line_of(table.columns) + "|---|";
  for (std::size_t i = 1; i < table.columns.size(); ++i) text += "---:|";
  text += "\n";
  for (const auto& row : table.rows) text += line_of(row);
  return text;
}

std::string with_blocks(const std::string& text, const std::map<std::string, std::string>& blocks) {
  const std::string begin = "<!-- results: ", close = " -->\n", end = "<!-- end -->\n";
  std::string result;
  std::set<std::string> seen;
  std::size_t done = 0;
  for (std::size_t mark = 0; (mark = text.find(begin, done)) != std::string::npos;) {
    const std::size_t named = text.find(close, mark), ended = text.find(end, mark);
    if (named == std::string::npos || ended == std::string::npos || named > ended)
      throw std::runtime_error("a mark of results without an end: " + text.substr(mark, 60));
    const std::string name = text.substr(mark + begin.size(), named - mark - begin.size());
    const auto block = blocks.find(name);
    if (block == blocks.end()) throw std::runtime_error("no results are called " + name);
    seen.insert(name);
    result += text.substr(done, named + close.size() - done) + block->second;
    done = ended;
  }
  for (const auto& [name, block] : blocks)
    if (!seen.contains(name)) throw std::runtime_error("no place for the results " + name);
  return result + text.substr(done);
}

}  // namespace dashpad::bench
