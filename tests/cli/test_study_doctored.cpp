// A store that somebody changed: whatever its texts hold, the terminal is told nothing but words.

#include <gtest/gtest.h>

#include "command.hpp"
#include "unit/small_study.hpp"

namespace dashpad::test {
namespace {

/// Of standard output and error: escapes and other control characters, in one byte or as UTF-8 (U+0080 to
/// U+009F).
std::string control_characters(const std::string& text) {
  std::string found;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    const auto next = i + 1 < text.size() ? static_cast<unsigned char>(text[i + 1]) : 0;
    if ((byte < 0x20 && byte != '\n') || byte == 0x7f || (byte == 0xc2 && next >= 0x80 && next < 0xa0))
      found += std::to_string(byte) + " before \"" + text.substr(i + 1, 20) + "\"; ";
  }
  return found;
}

class StudyDoctored : public CommandTest {
 protected:
  void SetUp() override {
    CommandTest::SetUp();
    fs::create_directory(file("cards"));
    const std::string card =
        "title = \"Foam\"\nsource = \"made up\"\nlaw = \"elastic\"\n[parameters]\nmodulus = \"300 kPa\"\n";
    write_file(file("cards/foam.toml"), card);
    write_file(file("cards/other.toml"), with(card, "300 kPa", "200 kPa"));
    write_file(file("study.toml"), R"(title = "Doctored"
case = "case.toml"
responses = ["peak_force", "hic15"]
[factors."impactor.speed"]
values = ["2 m/s", "3 m/s", "4 m/s"]
[factors."pad.material"]
values = ["foam", "other"]
)");
    ASSERT_EQ(dashpad(study()).exit_code, 0);
    fs::copy_file(file("s.db"), file("good.db"));
  }
  [[nodiscard]] std::vector<std::string> study() const {
    return {"study", file("study.toml"), "--out", file("s.db"), "--materials", file("cards")};
  }
  void change(const std::string& sql) const {
    fs::copy_file(file("good.db"), file("s.db"), fs::copy_options::overwrite_existing);
    test::edit(file("s.db"), sql);
  }
};

TEST_F(StudyDoctored, a_level_that_the_study_does_not_have_is_no_level) {
  for (const char* sql : {"UPDATE samples SET \"impactor.speed\" = 7 WHERE row = 0",
                          "UPDATE samples SET \"pad.material\" = 2 WHERE row = 1"}) {
    change(sql);
    const auto summary = dashpad({"study", "summary", file("s.db"), "--report", file("s.html")});
    EXPECT_EQ(summary.exit_code, 2) << sql;
    EXPECT_NE(summary.err.find("which is not one of its levels"), std::string::npos) << summary.err;
    EXPECT_FALSE(fs::exists(file("s.html")));
  }
}

TEST_F(StudyDoctored, writes_no_escape_codes_to_the_terminal) {
  const std::string escape = "char(27) || '[31m' || char(7) || char(155) || '2J'";
  std::vector<std::string> changes;
  for (const char* place :
       {"study SET value = value || ESC WHERE key = 'title'",
        "study SET value = ESC || value WHERE key = 'text'",
        "study SET value = value || ESC WHERE key = 'program'",
        "study SET value = ESC WHERE key = 'resolved'", "study SET value = value || ESC WHERE key = 'rows'",
        "factors SET key = key || ESC", "factors SET unit = ESC", "responses SET name = name || ESC",
        "responses SET unit = ESC", "responses SET meaning = ESC", "materials SET name = ESC",
        "samples SET status = ESC", "samples SET peak_force = ESC", "samples SET error = ESC"})
    changes.push_back("UPDATE " + with(place, "ESC", escape));
  // Texts within the JSON of the study, as it writes an escape code.
  for (const char* word : {"Doctored", "Elastic", "foam", "Foam", "m/s", "impactor.speed", "peak_force"})
    changes.push_back("UPDATE study SET value = replace(value, '" + std::string{word} + "', '" + word +
                      "\\u001b[31m\\u009b2J') WHERE key = 'resolved'");
  // What SQLite says of a table quotes its text.
  changes.emplace_back(
      "ALTER TABLE samples RENAME TO kept; CREATE VIEW samples AS SELECT * FROM \"\x1b[31m\"");
  changes.emplace_back("ALTER TABLE study RENAME TO kept; CREATE VIEW study AS SELECT \"\x1b[31m\"() AS key");
  for (const std::string& sql : changes) {
    change(sql);
    int answered = 0;
    for (const std::vector<std::string>& command :
         {std::vector<std::string>{"study", "summary", file("s.db"), "--limit", "peak_force > 1 kN"},
          {"study", "summary", file("s.db"), "--response", "none"},
          {"study", "summary", file("s.db"), "--json", "-"},
          {"study", "replay", file("s.db"), "1"},
          {"study", "export", file("s.db"), "--csv", "-"},
          study()}) {
      const Outcome outcome = dashpad(command);
      EXPECT_EQ(control_characters(outcome.out), "") << sql << "\n" << command[1];
      EXPECT_EQ(control_characters(outcome.err), "") << sql << "\n" << command[1];
      EXPECT_LT(outcome.exit_code, 128) << sql << "\n" << command[1];
      if (!outcome.out.empty() || !outcome.err.empty()) ++answered;
    }
    EXPECT_EQ(answered, 6) << sql;
  }
}

TEST_F(StudyDoctored, replays_what_the_store_has_not_and_factors_that_were_changed) {
  change("UPDATE samples SET peak_force = NULL WHERE row = 2");
  Outcome outcome = dashpad({"study", "replay", file("s.db"), "2"});
  EXPECT_EQ(outcome.exit_code, 3) << outcome.err;
  EXPECT_NE(outcome.out.find("peak_force: stored none, now "), std::string::npos) << outcome.out;
  EXPECT_EQ(outcome.out.find("nan"), std::string::npos) << outcome.out;
  change("UPDATE samples SET \"impactor.speed\" = 7 WHERE row = 2");
  outcome = dashpad({"study", "replay", file("s.db"), "2"});
  EXPECT_EQ(outcome.exit_code, 3) << outcome.err;
  EXPECT_NE(outcome.out.find("Row 2: impactor.speed = 3 m/s"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("impactor.speed: stored 7, now 3 m/s"), std::string::npos) << outcome.out;
  change("UPDATE samples SET error = NULL WHERE row = 2");
  outcome = dashpad({"study", "replay", file("s.db"), "2"});
  EXPECT_EQ(outcome.exit_code, 2) << outcome.out;
}

TEST_F(StudyDoctored, says_nothing_of_a_response_that_no_draw_has) {
  write_file(file("study.toml"), R"(title = "Doctored"
case = "case.toml"
samples = 5
responses = ["peak_force"]
[factors."impactor.speed"]
distribution = "uniform"
low = "2 m/s"
high = "4 m/s"
)");
  fs::remove(file("s.db"));
  ASSERT_EQ(dashpad(study()).exit_code, 0);
  test::edit(file("s.db"), "UPDATE samples SET peak_force = NULL");
  const Outcome outcome = dashpad({"study", "summary", file("s.db")});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.out.find("Peak force: ."), std::string::npos) << outcome.out;
}

/// SQLite takes a cut page for one that ends in zeros, and a file shorter than a page for a new one.
TEST_F(StudyDoctored, is_refused_where_its_end_is_missing) {
  const auto size = fs::file_size(file("good.db"));
  for (const std::uintmax_t kept : {std::uintmax_t{1}, std::uintmax_t{300}, size - 1}) {
    fs::copy_file(file("good.db"), file("s.db"), fs::copy_options::overwrite_existing);
    fs::resize_file(file("s.db"), kept);
    for (const std::vector<std::string>& command :
         {std::vector<std::string>{"study", "summary", file("s.db")},
          {"study", "export", file("s.db"), "--csv", file("rows.csv")},
          {"study", "replay", file("s.db"), "2"},
          study()}) {
      const Outcome outcome = dashpad(command);
      EXPECT_EQ(outcome.exit_code, 2) << kept << " " << command[1] << outcome.out << outcome.err;
      EXPECT_EQ(fs::file_size(file("s.db")), kept) << command[1];
    }
  }
}

TEST_F(StudyDoctored, is_refused_where_a_number_cannot_be) {
  for (const char* number : {"9e999", "-9e999", "-1"}) {
    change("UPDATE samples SET peak_force = " + std::string{number} + " WHERE row = 2");
    for (const std::vector<std::string>& command :
         {std::vector<std::string>{"study", "summary", file("s.db")},
          {"study", "export", file("s.db"), "--csv", file("rows.csv")},
          {"study", "replay", file("s.db"), "2"}}) {
      const Outcome outcome = dashpad(command);
      EXPECT_EQ(outcome.exit_code, 2) << number << command[1];
      EXPECT_NE(outcome.err.find("the store is damaged (peak_force"), std::string::npos) << outcome.err;
      EXPECT_EQ(outcome.out, "");
    }
    EXPECT_FALSE(fs::exists(file("rows.csv")));
  }
}

/// One exit code, and no word of SQL.
TEST_F(StudyDoctored, is_refused_alike_whatever_the_damage) {
  for (const char* sql :
       {"UPDATE responses SET unit = 'kN' WHERE position = 0",
        "UPDATE factors SET unit = 'mph' WHERE position = 0",
        "ALTER TABLE samples RENAME COLUMN peak_force TO force", "DROP TABLE batches",
        "UPDATE batches SET rows = 'x' WHERE batch = 1", "UPDATE samples SET row = -5 WHERE row = 0",
        "UPDATE samples SET peak_force = 'much'", "UPDATE study SET value = 'x' WHERE key = 'rows'",
        "UPDATE study SET value = '{}' WHERE key = 'resolved'"}) {
    change(sql);
    for (const std::vector<std::string>& command :
         {std::vector<std::string>{"study", "summary", file("s.db")},
          {"study", "export", file("s.db"), "--csv", file("rows.csv")},
          {"study", "replay", file("s.db"), "0"}}) {
      const Outcome outcome = dashpad(command);
      EXPECT_EQ(outcome.exit_code, 2) << sql << "\n" << command[1];
      EXPECT_NE(outcome.err.find("s.db: the store is damaged"), std::string::npos) << sql << "\n"
                                                                                   << outcome.err;
      for (const char* word : {"coalesce", "count(", "no such", "sqlite", "SQL"})
        EXPECT_EQ(outcome.err.find(word), std::string::npos) << sql << "\n" << outcome.err;
    }
  }
  const std::uintmax_t size = fs::file_size(file("good.db"));
  for (const std::uintmax_t part : {size / 2, std::uintmax_t{4096}, std::uintmax_t{100}}) {
    fs::copy_file(file("good.db"), file("s.db"), fs::copy_options::overwrite_existing);
    fs::resize_file(file("s.db"), part);
    for (const char* command : {"summary", "replay"}) {
      std::vector<std::string> line{"study", command, file("s.db")};
      if (line[1] == "replay") line.emplace_back("0");
      EXPECT_EQ(dashpad(line).exit_code, 2) << part << command;
    }
  }
}

}  // namespace
}  // namespace dashpad::test
