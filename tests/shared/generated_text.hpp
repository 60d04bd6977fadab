#pragma once
/// Parts of documents that are made from tables of the program, and held to them.

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace dashpad::test {

/// Whether tests write what they would compare.
inline bool is_regenerating() { return std::getenv("DASHPAD_REGENERATE") != nullptr; }

inline std::string text_of(const std::filesystem::path& file) {
  std::ifstream stream(file);
  return {std::istreambuf_iterator<char>(stream), {}};
}

inline void write_text(const std::filesystem::path& file, const std::string& text) {
  std::ofstream(file) << text;
}

/// What stands in a document between "<!-- begin NAME -->" and "<!-- end NAME -->".
inline void expect_generated(const std::filesystem::path& document, const std::string& name,
                             const std::string& made) {
  std::string text = text_of(document);
  const std::string begin = "<!-- begin " + name + " -->\n", end = "<!-- end " + name + " -->";
  const std::size_t from = text.find(begin) + begin.size(), to = text.find(end);
  ASSERT_TRUE(text.find(begin) != std::string::npos && to != std::string::npos && from <= to) << name;
  if (is_regenerating())
    write_text(document, text.replace(from, to - from, "\n" + made + "\n"));
  else
    EXPECT_EQ(text.substr(from, to - from), "\n" + made + "\n") << name;
}

}  // namespace dashpad::test
