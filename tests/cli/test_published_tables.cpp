// Pulses and compression tests in the layouts that the documents of instruments and programs publish: each is
// read, with the options that only a user can know, or refused in one sentence. The tables `origins.tsv`
// beside them name the document of each, the options, and either "peak 80 g at 7 ms", "62.76 kPa at 0.25" or
// "refused: " with a piece of the sentence.

#include <cmath>
#include <map>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "command.hpp"

namespace dashpad::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

const fs::path published = DASHPAD_SOURCE_DIR "/tests/cli/published";

struct PublishedExample {
  std::string file, origin, options, expected;
};

std::vector<PublishedExample> examples_of(const std::string& kind) {
  std::istringstream lines(read_file(published / kind / "origins.tsv"));
  std::vector<PublishedExample> all;
  std::string line;
  std::getline(lines, line);
  EXPECT_EQ(line, "file\torigin\toptions\texpected");
  while (std::getline(lines, line)) {
    std::istringstream fields(line);
    PublishedExample& example = all.emplace_back();
    for (std::string* field : {&example.file, &example.origin, &example.options, &example.expected})
      std::getline(fields, *field, '\t');
    EXPECT_FALSE(example.expected.empty()) << line;
  }
  return all;
}

/// Whether the example is to be refused; then it must be, in one sentence.
bool is_refused(const PublishedExample& example, const Outcome& outcome) {
  const std::string mark = "refused: ";
  if (!example.expected.starts_with(mark)) {
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return outcome.exit_code != 0;
  }
  EXPECT_EQ(outcome.exit_code, 2) << outcome.out;
  EXPECT_THAT(outcome.err, AllOf(HasSubstr(example.expected.substr(mark.size())), HasSubstr("\n1 error")));
  return true;
}

/// The numbers of an array in a section of a card.
std::vector<double> numbers_in(const std::string& card, const std::string& section, const std::string& key) {
  const auto begin = card.find("\n[" + section + "]\n");
  if (begin == std::string::npos) return {};
  const auto open = card.find("\n" + key + " = [", begin) + key.size() + 5;
  std::istringstream text(card.substr(open, card.find(']', open) - open));
  std::vector<double> numbers;
  for (std::string number; std::getline(text, number, ',');) numbers.push_back(std::stod(number));
  return numbers;
}

/// The stress of a card, kPa, on straight lines between its points.
double stress_in(const std::string& card, const std::string& section, double strain) {
  const std::vector<double> strains = numbers_in(card, section, "strain"),
                            stresses = numbers_in(card, section, "stress");
  for (std::size_t i = 1; i < std::min(strains.size(), stresses.size()); ++i)
    if (strains[i - 1] <= strain + 1e-9 && strain <= strains[i] + 1e-9)
      return 1e-3 * (stresses[i - 1] + (stresses[i] - stresses[i - 1]) * (strain - strains[i - 1]) /
                                           (strains[i] - strains[i - 1]));
  return std::nan("");
}

TEST(PublishedTables, PulsesAreReadOrRefusedInOneSentence) {
  for (const PublishedExample& example : examples_of("pulses")) {
    SCOPED_TRACE(example.file + " " + example.options + ", after " + example.origin);
    const Outcome outcome = shell("cd '" + (published / "pulses").string() + "' && \"$DASHPAD\" pulse " +
                                  example.file + " " + example.options + " --json -");
    if (is_refused(example, outcome)) continue;
    std::istringstream words(example.expected);
    std::string word;
    double peak = 0, time = 0;
    words >> word >> peak >> word >> word >> time;
    ASSERT_GT(peak, 0);
    const auto found = nlohmann::json::parse(outcome.out)["figures"]["peak_acceleration"];
    EXPECT_NEAR(std::abs(found["value_g"].get<double>()), peak, 1e-3 * peak);
    EXPECT_NEAR(1e3 * found["time_s"].get<double>(), time, 0.01);
  }
}

TEST(PublishedTables, CompressionTestsAreReadOrRefusedInOneSentence) {
  for (const PublishedExample& example : examples_of("tests")) {
    SCOPED_TRACE(example.file + " " + example.options + ", after " + example.origin);
    const Outcome outcome =
        shell("cd '" + (published / "tests").string() + "' && \"$DASHPAD\" material import " + example.file +
              " " + example.options);
    if (is_refused(example, outcome)) continue;
    std::istringstream pieces(example.expected);
    for (std::string piece; std::getline(pieces, piece, ';');) {
      std::istringstream words(piece);
      std::string word, section = "curve";
      words >> word;
      if (word == "unloading") {
        section = word;
        words >> word;
      }
      const double stress = std::stod(word);
      double strain = 0;
      words >> word >> word >> strain;
      EXPECT_NEAR(stress_in(outcome.out, section, strain), stress, 1e-3 * stress) << section << " " << strain;
    }
  }
}

}  // namespace
}  // namespace dashpad::test
