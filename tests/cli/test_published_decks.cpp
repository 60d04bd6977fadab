// Decks in the layouts that the formats' own documents publish: each is read with the right numbers, or
// refused in one sentence. The table tests/cli/published/decks/origins.tsv names the documents.

#include <cmath>
#include <cstdlib>
#include <optional>
#include <sstream>
#include <variant>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "command.hpp"
#include "dashpad/input/case_file.hpp"

namespace dashpad::test {
namespace {

using testing::HasSubstr;

const fs::path published_decks = DASHPAD_SOURCE_DIR "/tests/cli/published/decks";

std::vector<std::string> pieces_of(const std::string& text, char separator) {
  std::vector<std::string> pieces;
  std::istringstream stream(text);
  for (std::string piece; std::getline(stream, piece, separator);) pieces.push_back(piece);
  return pieces;
}

/// The stress of straight lines through the points, Pa; NaN beyond them.
double stress_at(const TableCurve& curve, double strain) {
  for (std::size_t i = 1; i < curve.strain.size(); ++i)
    if (strain >= curve.strain[i - 1] - 1e-9 && strain <= curve.strain[i] + 1e-9)
      return std::lerp(curve.stress[i - 1], curve.stress[i],
                       (strain - curve.strain[i - 1]) / (curve.strain[i] - curve.strain[i - 1]));
  return std::nan("");
}

/// The curve of a rate, 1/s, or the base curve; null if there is none.
const TableCurve* curve_of(const Material& material, std::optional<double> rate) {
  const FoamCurves* const curves = foam_curves(material.law);
  if (curves == nullptr) return nullptr;
  if (!rate) return std::get_if<TableCurve>(&curves->base);
  if (const auto* const effect = std::get_if<CurvesRateEffect>(&curves->rate_effect))
    for (const CurvesRateEffect::AtRate& at : effect->curves)
      if (std::abs(at.rate / *rate - 1) < 1e-9) return &at.curve;
  return nullptr;
}

/// The number of a key in the text of a card, in the unit of SI that the card gives it in.
double number_in_card(const std::string& card, const std::string& key) {
  const auto at = card.find("\n" + key + " = ");
  if (at == std::string::npos) return std::nan("");
  return std::strtod(card.c_str() + card.find_first_of("-.0123456789", at + key.size() + 3), nullptr);
}

/// `entry` is "law foam", "stress@0.3 142000", "stress@0.3@100 213000" (strain, rate in 1/s, stress in Pa) or
/// a key of the card with its number, "density 60".
void expect_entry(const std::string& card, const Material& material, const std::string& entry) {
  SCOPED_TRACE(entry);
  std::istringstream words(entry);
  std::string name, value;
  words >> name >> value;
  if (name == "law") {
    EXPECT_EQ(name_of(material.law), value);
    return;
  }
  const double expected = std::strtod(value.c_str(), nullptr);
  const std::vector<std::string> place = pieces_of(name, '@');
  if (place.front() != "stress") {
    EXPECT_NEAR(number_in_card(card, name), expected, 1e-9 * std::abs(expected));
    return;
  }
  const auto rate = place.size() > 2 ? std::optional(std::stod(place[2])) : std::nullopt;
  const TableCurve* const curve = curve_of(material, rate);
  ASSERT_NE(curve, nullptr);
  EXPECT_NEAR(stress_at(*curve, std::stod(place.at(1))), expected, 1e-3 * expected);
}

using PublishedDecks = CommandTest;

TEST_F(PublishedDecks, AreReadRightOrRefusedInOneSentence) {
  const std::vector<std::string> rows = pieces_of(read_file(published_decks / "origins.tsv"), '\n');
  ASSERT_GT(rows.size(), 40u);
  const std::string refused = "refused: ";
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const std::vector<std::string> row = pieces_of(rows[i], '\t');
    ASSERT_EQ(row.size(), 5u) << rows[i];
    const std::string &name = row[0], &options = row[1], &expected = row[2];
    SCOPED_TRACE(name + " " + options);
    std::vector<std::string> arguments{"material", "import", (published_decks / name).string()};
    for (const std::string& option : pieces_of(options, ' ')) arguments.push_back(option);
    const Outcome outcome = dashpad(arguments);
    if (expected.starts_with(refused)) {
      EXPECT_EQ(outcome.exit_code, 2) << outcome.out;
      EXPECT_THAT(outcome.err, HasSubstr(expected.substr(refused.size())));
      EXPECT_THAT(outcome.err, HasSubstr("\n1 error\n"));
      continue;
    }
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    if (outcome.exit_code != 0) continue;
    write_file(file("card.toml"), outcome.out);
    const Material material = input::read_material(file("card.toml")).value();
    for (const std::string& entry : pieces_of(expected, ';')) expect_entry(outcome.out, material, entry);
  }
}

}  // namespace
}  // namespace dashpad::test
