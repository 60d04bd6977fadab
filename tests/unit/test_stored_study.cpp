// A study comes out of its store as it went in, and its rows are put together rightly.

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dashpad/io/case_file.hpp"
#include "dashpad/report/study_report.hpp"
#include "dashpad/study/batch.hpp"
#include "dashpad/study/run_study.hpp"
#include "dashpad/study/stored_study.hpp"
#include "dashpad/study/study_file.hpp"
#include "small_study.hpp"
#include "temporary_folder.hpp"

namespace dashpad::testing {
namespace {

using study::Store;
using study::Study;
namespace fs = std::filesystem;

const fs::path source{DASHPAD_SOURCE_DIR};

class StoredStudyTest : public ::testing::Test {
 protected:
  /// The rows of a study that was stored, read, and computed again.
  void expect_same_rows(const Study& study, const std::string& name) {
    const Store store = Store::open_for(study, folder_.path() / name);
    const Study read = study::stored_study(store);
    EXPECT_TRUE(store.is_of(read)) << name;
    EXPECT_EQ(read.title, study.title);
    EXPECT_EQ(read.responses, study.responses);
    const study::Design design{study}, again{read};
    ASSERT_EQ(design.rows(), again.rows());
    study::Worker worker{study, design}, other{read, again};
    const auto rows = worker.compute(1, 2), same = other.compute(1, 2);
    ASSERT_EQ(rows.size(), same.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
      EXPECT_EQ(rows[i].factors, same[i].factors) << name;
      EXPECT_EQ(rows[i].outcome.error, same[i].outcome.error) << name;
    }
  }
  [[nodiscard]] fs::path file(const char* name) const { return folder_.path() / name; }

 private:
  TemporaryFolder folder_;
};

TEST_F(StoredStudyTest, TheStudiesOfTheExamples) {
  int count = 0;
  for (const auto& entry : fs::directory_iterator(source / "examples/studies")) {
    if (entry.path().extension() != ".toml") continue;
    expect_same_rows(study::read_study(entry.path(), source / "materials"),
                     entry.path().stem().string() + ".db");
    ++count;
  }
  EXPECT_GE(count, 3);
}

TEST_F(StoredStudyTest, EveryCard) {
  for (const fs::path& card : list_materials(source / "materials")) {
    Study study = small_study(10);
    study.base.pad.material = read_material(card);
    study.base.support = Support::through({{0.001, 50}, {0.003, 1000}});
    expect_same_rows(study, card.stem().string() + ".db");
  }
}

TEST_F(StoredStudyTest, ADamagedStudyIsRefused) {
  { Store::open_for(small_study(10), file("small.db")); }
  edit(file("small.db"), "UPDATE study SET value = replace(value, '0.08', '0.09') WHERE key = 'resolved'");
  EXPECT_NO_THROW(study::stored_study(Store::open_to_read(file("small.db"))))
      << "another radius is a study, too";
  edit(file("small.db"),
       "UPDATE study SET value = replace(value, '\"elastic\"', '\"rubber\"') WHERE key = 'resolved'");
  EXPECT_THROW(study::stored_study(Store::open_to_read(file("small.db"))), std::runtime_error);
  edit(file("small.db"), "UPDATE study SET value = 'no JSON' WHERE key = 'resolved'");
  EXPECT_THROW(study::stored_study(Store::open_to_read(file("small.db"))), std::runtime_error);
}

/// Two speeds, three draws with indices: each group has the rows of both matrices and no others.
TEST_F(StoredStudyTest, GroupsAreTheDrawsOfOneCombination) {
  Study study = small_study(2);
  study.factors.push_back(
      {.key = "impactor.mass", .unit = "kg", .spread = study::Uniform{4, 6}, .lowest = {}, .highest = {}});
  study.samples = 3;
  study.indices = true;
  Store store = Store::open_for(study, file("groups.db"));
  ASSERT_TRUE(study::run(study, store));
  const study::Records records = study::read_records(study, store);
  ASSERT_EQ(records.rows.size(), 2U * 3 * 3);
  const auto groups = study::groups(study, study::Design{study}, records);
  ASSERT_EQ(groups.size(), 2U);
  for (const study::Group& group : groups) {
    EXPECT_EQ(group.places.size(), 6U);
    ASSERT_EQ(group.levels.size(), 1U);
    for (const std::size_t place : group.places) EXPECT_EQ(records.factors[0][place], group.levels[0]);
  }
  EXPECT_NE(groups[0].levels, groups[1].levels);
}

/// The static stress of every point is its weight over the area at its own penetration, and the deceleration
/// is that of its own row.
TEST_F(StoredStudyTest, CushionCurvesHoldTheRowsInOrder) {
  Study study = small_study(2);
  const auto levels = [](const char* key, const char* unit, std::vector<double> values) {
    return study::Factor{
        .key = key, .unit = unit, .spread = study::Levels{std::move(values)}, .lowest = {}, .highest = {}};
  };
  study.factors.push_back(levels("pad.thickness", "m", {0.06, 0.04}));
  study.factors.push_back(levels("impactor.mass", "kg", {3, 1, 2}));
  study.responses = {"peak_penetration", "peak_acceleration"};
  Store store = Store::open_for(study, file("cushion.db"));
  ASSERT_TRUE(study::run(study, store));
  const study::Records records = study::read_records(study, store);
  const auto curves = study::cushion_curves(study, records);
  ASSERT_TRUE(curves.has_value());
  ASSERT_EQ(curves->drops.size(), 2U);
  const study::CushionCurve& thin = curves->drops[0].curves.at(0);
  EXPECT_EQ(thin.thickness, 0.04);
  ASSERT_EQ(thin.static_stress.size(), 3U);
  for (std::size_t place = 0; place < records.rows.size(); ++place) {
    if (records.factors[0][place] != curves->drops[0].speed || records.factors[1][place] != 0.04) continue;
    const double mass = records.factors[2][place];
    const auto i = static_cast<std::size_t>(mass) - 1;
    EXPECT_EQ(thin.peak_deceleration[i], records.responses[1][place]);
    EXPECT_DOUBLE_EQ(thin.static_stress[i],
                     mass * standard_gravity / study::contact_area(0.08, records.responses[0][place]));
  }
  study.responses = {"peak_acceleration"};
  EXPECT_FALSE(study::cushion_curves(study, records).has_value()) << "no penetration, no area";
}

TEST_F(StoredStudyTest, AnUnfinishedStudyIsSummedUpWithAWarning) {
  Study study = small_study(1000);
  Store store = Store::open_for(study, file("begun.db"));
  store.write_batch(2, made_up_batch(store, 2));
  const StudyAnswers answers = study_answers(store, {.responses = {"peak_force"}, .limits = {}});
  EXPECT_EQ(answers.records.rows.front(), 2 * store.batch_size());
  EXPECT_THAT(study_text(answers, unit_systems().front()), ::testing::HasSubstr("NOT COMPLETE"));
  EXPECT_THROW(study_answers(store, {.responses = {"hic51"}, .limits = {}}), std::invalid_argument);
}

}  // namespace
}  // namespace dashpad::testing
