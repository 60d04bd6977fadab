// A study comes out of its store as it went in, and its rows are put together rightly.

#include <cmath>
#include <limits>
#include <tuple>
#include <type_traits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dashpad/input/case_file.hpp"
#include "dashpad/output/study.hpp"
#include "dashpad/study/run_study.hpp"
#include "dashpad/study/study_file.hpp"
#include "sample_case.hpp"
#include "shared/temporary_folder.hpp"
#include "small_study.hpp"

namespace dashpad::test {
namespace {

std::string tables_of(const study::StudyAnswers& answers) {
  return output::to_markdown(output::study_document(answers, unit_systems().front()));
}

std::string told(const study::StudyAnswers& answers) {
  return output::to_terminal(output::study_document(answers, unit_systems().front()), output::Detail::main);
}

using study::Store;
using study::Study;
namespace fs = std::filesystem;

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
  test::TemporaryFolder folder_;
};

TEST_F(StoredStudyTest, TheStudiesOfTheExamples) {
  int count = 0;
  for (const auto& entry : fs::directory_iterator(source / "examples/studies")) {
    if (entry.path().extension() != ".toml") continue;
    expect_same_rows(study::read_study(entry.path(), source / "materials", source / "standards").value(),
                     entry.path().stem().string() + ".db");
    ++count;
  }
  EXPECT_GE(count, 3);
}

TEST_F(StoredStudyTest, EveryNoseOnAPadWithAnEdge) {
  int count = 0;
  for (const Nose& nose :
       std::vector<Nose>{FlatDisc{0.05}, Cone{0.08, 1.1, 0.01}, Cone{0.08, 0.7}, Ellipsoid{0.06, 0.09, 0.05},
                         Rod{0.03, 0.08}, Platen{0.1, 0.08}, Cylinder{0.06, 0.1},
                         Profile{.scale = 1.5, .points = {{0, 0.01}, {0.01, 0.03}, {0.04, 0.05}}},
                         Profile{.of = Profile::Of::area, .points = {{0, 0}, {0.04, 0.01}}}}) {
    const std::string name = name_of(nose) + std::to_string(++count) + ".db";
    Study study = small_study(10);
    study.base.impactor.nose = nose;
    study.base.pad.area = 0.004;
    if (!std::holds_alternative<Cylinder>(nose)) study.base.pad.sheet = 3;
    expect_same_rows(study, name);
    const Study read = study::stored_study(Store::open_to_read(file(name.c_str())));
    EXPECT_EQ(read.base.pad.area, 0.004);
    EXPECT_EQ(read.base.pad.sheet, study.base.pad.sheet);
    EXPECT_EQ(name_of(read.base.impactor.nose), name_of(nose));
    if (const auto* profile = std::get_if<Profile>(&nose)) {
      const auto& same = std::get<Profile>(read.base.impactor.nose);
      EXPECT_EQ(same.of, profile->of);
      EXPECT_EQ(same.points, profile->points);
      EXPECT_EQ(same.scale, profile->scale);
    }
  }
}

TEST_F(StoredStudyTest, SupportsThatMove) {
  Study study = small_study(3);
  study.base.support = Support::linear(2e5);
  study.base.backing = {.unloading_stiffness = 4e5, .damping = 30, .mass = 1.5, .earlier_force = 20};
  study.base.impactor.gravity = 9.81;
  study.factors.push_back({.key = "support.damping",
                           .unit = "N s/m",
                           .spread = study::Levels{{0, 100}},
                           .lowest = {},
                           .highest = {}});
  expect_same_rows(study, "moving.db");
  const Study read = study::stored_study(Store::open_to_read(file("moving.db")));
  EXPECT_EQ(read.base.backing, study.base.backing);
  EXPECT_EQ(read.base.impactor.gravity, 9.81);
}

TEST_F(StoredStudyTest, RepeatedBlowsOnAPadThatWasStruckBefore) {
  Study study = small_study(3);
  study.base.pad.material = input::read_material(source / "materials/vn600.toml").value();
  study.base.pad.earlier_penetration = 1e-3;
  study.base.blows = Blows{.count = 3, .recovery = 0.5};
  study.factors.push_back(
      {.key = "blows.recovery", .unit = "1", .spread = study::Levels{{0, 1}}, .lowest = {}, .highest = {}});
  expect_same_rows(study, "blows.db");
  const Study read = study::stored_study(Store::open_to_read(file("blows.db")));
  ASSERT_TRUE(read.base.blows);
  EXPECT_EQ(read.base.blows->count, 3);
  EXPECT_EQ(read.base.blows->recovery, 0.5);
  EXPECT_EQ(read.base.pad.earlier_penetration, 1e-3);
}

/// Changes each number of an owner, a part of a study, and looks for it in the text of the study.
template <class Place>
void expect_every_number(const Study& study, Place place) {
  using Owner = std::remove_cvref_t<decltype(place(study))>;
  for (const Parameter<Owner>& parameter : Owner::parameters) {
    Study changed = study;
    Owner& owner = place(changed);
    parameter.set(owner, parameter.is_none(owner) ? 1 : 2 * parameter.of(owner) + 1);
    EXPECT_NE(study::resolved_text(changed), study::resolved_text(study)) << parameter.key;
  }
}

/// With a number that is written but not read a store counts as damaged.
TEST_F(StoredStudyTest, TheTextOfAStudyHasEveryNumberOfItsCase) {
  Study study = small_study(3);
  study.base.blows = Blows{};
  study.base.pad.layers.resize(1);
  expect_every_number(
      study, [](auto& in) -> auto& { return in.base.impactor; });
  expect_every_number(
      study, [](auto& in) -> auto& { return in.base.pad; });
  expect_every_number(
      study, [](auto& in) -> auto& { return in.base.pad.condition; });
  expect_every_number(
      study, [](auto& in) -> auto& { return in.base.pad.layers[0]; });
  expect_every_number(
      study, [](auto& in) -> auto& { return in.base.backing; });
  expect_every_number(
      study, [](auto& in) -> auto& { return *in.base.blows; });
  expect_every_number(
      study, [](auto& in) -> auto& { return in.options; });
}

TEST_F(StoredStudyTest, EveryCard) {
  for (const fs::path& card : input::list_materials(source / "materials").value()) {
    Study study = small_study(10);
    study.base.pad.material = input::read_material(card).value();
    study.base.support = Support::through({{0.001, 50}, {0.003, 1000}});
    expect_same_rows(study, card.stem().string() + ".db");
  }
}

TEST_F(StoredStudyTest, NumbersOfCurves) {
  Study study = small_study(3);
  study.base.pad.material = input::read_material(source / "materials/plastazote-ld33.toml").value();
  study.factors.push_back({.key = "pad.curve.plateau_stress",
                           .unit = "Pa",
                           .spread = study::Levels{{4e3, 6e3}},
                           .lowest = {},
                           .highest = {}});
  expect_same_rows(study, "curves.db");
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

TEST_F(StoredStudyTest, CountsThatNoStudyHasAreRefused) {
  { Store::open_for(small_study(10), file("good.db")); }
  ASSERT_NO_THROW(study::stored_study(Store::open_to_read(file("good.db"))));
  for (const auto& [from, to] : std::vector<std::pair<std::string, std::string>>{
           {"\"method\": 2", "\"method\": 7"},
           {"\"samples\": 1", "\"samples\": -1"},
           {"\"seed\": 1", "\"seed\": 1e300"},
           {"400000", "1e300"},
           {"\"correlations\": []", "\"correlations\": [[1e300, 0, 0.5]]"}}) {
    fs::copy_file(file("good.db"), file("bad.db"), fs::copy_options::overwrite_existing);
    edit(file("bad.db"),
         "UPDATE study SET value = replace(value, '" + from + "', '" + to + "') WHERE key = 'resolved'");
    EXPECT_THROW(study::stored_study(Store::open_to_read(file("bad.db"))), std::runtime_error) << to;
  }
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

TEST_F(StoredStudyTest, CountsRowsByWhatIsToBeSaidOfThem) {
  const Study study = small_study(60);
  Store store = Store::open_for(study, file("counts.db"));
  for (const std::uint64_t batch : store.missing_batches()) {
    auto rows = made_up_batch(store, batch);
    for (study::StoredRow& row : rows) {
      row.factors = {std::get<study::Levels>(study.factors[0].spread).values[row.row]};
      row.outcome.extrapolated = (row.row % 3 == 0 ? study::extrapolated_strain : 0U) |
                                 (row.row % 4 == 0 ? study::extrapolated_rate : 0U);
    }
    store.write_batch(batch, rows);
  }
  const study::Records records = study::read_records(study, store);
  EXPECT_EQ(records.rows.size(), 60U);
  EXPECT_EQ(records.beyond_strain, 20U);
  EXPECT_EQ(records.beyond_rate, 15U);
  EXPECT_EQ(records.extrapolated, 30U);
  EXPECT_EQ(records.bottomed, 12U);
  EXPECT_EQ(records.time_limit, 9U);
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
  for (const study::CushionCurves::Drop& drop : curves->drops)
    EXPECT_DOUBLE_EQ(std::sqrt(2 * standard_gravity * drop.height), drop.speed);
  ASSERT_EQ(thin.static_stress.size(), 3U);
  for (std::size_t place = 0; place < records.rows.size(); ++place) {
    if (records.factors[0][place] != curves->drops[0].speed || records.factors[1][place] != 0.04) continue;
    const double heavy = records.factors[2][place];
    const auto i = static_cast<std::size_t>(heavy) - 1;
    EXPECT_EQ(thin.peak_deceleration[i], records.responses[1][place]);
    EXPECT_DOUBLE_EQ(thin.static_stress[i],
                     heavy * standard_gravity / Sphere{0.08}.sections().area(records.responses[0][place]));
  }
  EXPECT_FALSE(curves->whole_cushion);

  study.base.impactor.nose = Platen{0.1, 0.1};
  study.base.pad.area = 0.004;
  const auto of_block = study::cushion_curves(study, records);
  ASSERT_TRUE(of_block.has_value());
  EXPECT_TRUE(of_block->whole_cushion);
  EXPECT_DOUBLE_EQ(of_block->drops[0].curves.at(0).static_stress.at(1), 2 * standard_gravity / 0.004);

  study.responses = {"peak_acceleration"};
  EXPECT_FALSE(study::cushion_curves(study, records).has_value()) << "no penetration, no area";
}

/// Draws of a speed, with rows that nobody computed.
Study drawn_study(std::size_t draws) {
  Study study = small_study(2);
  study.factors = {
      {.key = "impactor.speed", .unit = "m/s", .spread = study::Uniform{1, 3}, .lowest = {}, .highest = {}}};
  study.samples = draws;
  study.responses = {"peak_force", "rebound_speed", "peak_strain"};
  return study;
}

constexpr double none = std::numeric_limits<double>::quiet_NaN();

study::StoredRow row_with(std::uint64_t number, Status status, std::vector<double> values) {
  study::StoredRow row{.row = number, .factors = {2}, .outcome = {}};
  row.outcome.status = status;
  row.outcome.bottomed = status == Status::bottomed_out;
  row.outcome.values = std::move(values);
  return row;
}

/// 1000 rows: 229 bottomed out on a rigid support, 1 is undecided in each way, the others have a peak force
/// of 1 kN.
study::StoredRow row_of_a_thousand(std::uint64_t number) {
  if (number < 229) return row_with(number, Status::bottomed_out, {none, none, 1});
  if (number == 229) return row_with(number, Status::tolerance_not_met, {1000, 2, 0.5});
  if (number == 230) return row_with(number, Status::time_limit, {1000, none, 0.5});
  if (number == 231) return row_with(number, Status::not_run, {none, none, none});
  if (number == 232) return row_with(number, Status::released, {none, 2, 0.5});
  return row_with(number, Status::released, {1000, 2, 0.5});
}

study::StudyAnswers answers_of_a_thousand(const fs::path& file, bool grid = false) {
  Study study = drawn_study(1000);
  if (grid) {
    study.factors = small_study(1000).factors;
    study.samples = 1;
  }
  Store store = Store::open_for(study, file);
  for (const std::uint64_t batch : store.missing_batches()) {
    std::vector<study::StoredRow> rows;
    for (std::uint64_t row = batch * store.batch_size();
         row < store.rows() && rows.size() < store.batch_size(); ++row)
      rows.push_back(row_of_a_thousand(row));
    store.write_batch(batch, rows);
  }
  return study::study_answers(
      store,
      {.responses = {},
       .limits = {{"peak_force", 5000}, {"peak_force", 500}, {"rebound_speed", 1}, {"peak_strain", 0.9}}});
}

/// A pad that bottomed out on a rigid support never counts as a pad with margin.
TEST_F(StoredStudyTest, RowsThatStruckThroughAreAboveEveryLimitOnAForce) {
  const study::StudyAnswers answers = answers_of_a_thousand(file("struck.db"));
  const auto& of = answers.groups.at(0);
  const study::Exceedance &high = of.exceedances.at(0), &low = of.exceedances.at(1);
  EXPECT_EQ(high.exceeding, 229U);
  EXPECT_EQ(high.struck_through, 229U);
  EXPECT_EQ(high.undecided, 4U) << "tolerance, time limit, not run, and a figure that is missing";
  EXPECT_NEAR(high.probability.value, 229.0 / 996, 1e-12);
  EXPECT_EQ(low.exceeding, 997U) << "the lower bound at the time limit is above this one";
  EXPECT_EQ(low.undecided, 3U);
  EXPECT_EQ(of.exceedances.at(2).struck_through, 0U) << "a rebound does not grow with the force";
  EXPECT_EQ(of.exceedances.at(2).undecided, 229U + 3U);
  EXPECT_EQ(of.exceedances.at(3).exceeding, 229U) << "the strain is 1 by its own figure";
  EXPECT_EQ(answers.records.struck_through, 229U);
  EXPECT_EQ(answers.records.doubtful, 3U) << "a released row without its peak force is one of them";
  const study::Distribution& force = of.distributions.at(0);
  EXPECT_EQ(force.struck_through, 229U);
  EXPECT_EQ(force.quantiles[5].value.value, std::numeric_limits<double>::infinity());
}

TEST_F(StoredStudyTest, RowsThatStruckThroughHaveAColumnOfTheirOwn) {
  using ::testing::AllOf;
  using ::testing::ContainsRegex;
  using ::testing::HasSubstr;
  for (const bool grid : {false, true}) {
    const study::StudyAnswers answers = answers_of_a_thousand(file(grid ? "grid.db" : "drawn.db"), grid);
    const std::string text = told(answers);
    EXPECT_THAT(text, AllOf(HasSubstr("BOTTOMED OUT: in 229 of 1000 rows (22.9 %)"),
                            HasSubstr("TIME LIMIT: in 1 of 1000 rows"), HasSubstr("DOUBTFUL: in 3 of 1000")));
    EXPECT_THAT(
        tables_of(answers),
        AllOf(
            ContainsRegex("Peak force \\| 5000 N \\| 22.99 \\([0-9.]+ to [0-9.]+\\) \\| 229 \\| 229 \\(22.9 "
                          "%\\) \\| 996 \\(4 undecided\\) "),
            // A grid has neither mean nor deviation.
            ContainsRegex(
                grid ? "Peak force \\(N\\) \\| [0-9]+ \\| 1000 \\| bottomed out \\| 229 \\(22.9 %\\)"
                     : "Peak force \\(N\\) \\| - \\| - \\| 1000 .* bottomed out .*229 \\(22.9 %\\)")));
    const auto page = output::study_document(answers, unit_systems().front(), output::Pictures::drawn);
    EXPECT_EQ(page.sections.at(1).tables.at(1).columns.at(4), "Bottomed out");
    EXPECT_EQ(page.sections.at(1).tables.at(1).rows.at(0).at(4), "229 (22.9 %)");
    EXPECT_THAT(output::study_json(answers),
                AllOf(HasSubstr("\"rows_struck_through\": 229"), HasSubstr("\"rows_undecided\": 4")));
  }
}

/// Without such rows there is no such column.
TEST_F(StoredStudyTest, AStudyOfWholePulsesHasNoColumnForThem) {
  const Study study = small_study(64);
  Store store = Store::open_for(study, file("whole.db"));
  ASSERT_TRUE(study::run(study, store));
  const std::string text =
      told(study::study_answers(store, {.responses = {}, .limits = {{"peak_force", 1}}}));
  EXPECT_THAT(text, ::testing::Not(::testing::HasSubstr("Bottomed out")));
}

TEST_F(StoredStudyTest, ALatinHypercubeNamesTheFactorsThatItDoesNotStratify) {
  Study study = drawn_study(100);
  study.sampling = study::Sampling::latin_hypercube;
  for (const auto& [key, unit, middle] :
       {std::tuple{"impactor.mass", "kg", 5.0}, std::tuple{"pad.thickness", "m", 0.05}})
    study.factors.push_back({.key = key,
                             .unit = unit,
                             .spread = study::Uniform{0.9 * middle, 1.1 * middle},
                             .lowest = {},
                             .highest = {}});
  const auto text_of = [&](const char* name) {
    Store store = Store::open_for(study, file(name));
    EXPECT_TRUE(study::run(study, store));
    return tables_of(study::study_answers(store, {}));
  };
  EXPECT_THAT(text_of("independent.db"), ::testing::Not(::testing::HasSubstr("Not stratified")));
  study.correlations = {{2, 0, 0.5}};
  EXPECT_THAT(text_of("correlated.db"), ::testing::HasSubstr("Not stratified: thickness of the pad. Of two"));
}

/// A store whose columns are not those of its study is no store of it.
TEST_F(StoredStudyTest, OtherColumnsThanTheStudyHasAreRefused) {
  for (const char* change :
       {"UPDATE responses SET name = 'hic15' WHERE position = 0", "UPDATE responses SET unit = 'kN'",
        "UPDATE factors SET unit = 'mph'",
        "UPDATE study SET value = replace(value, 'm/s', 'furlong') WHERE key = 'resolved'",
        "UPDATE study SET value = replace(value, 'peak_force', 'peak_strain') WHERE key = 'resolved'",
        "UPDATE study SET value = 20 WHERE key = 'rows'"}) {
    fs::remove(file("other.db"));
    { Store::open_for(small_study(10), file("other.db")); }
    edit(file("other.db"), change);
    EXPECT_THROW(study::stored_study(Store::open_to_read(file("other.db"))), std::runtime_error) << change;
  }
}

TEST_F(StoredStudyTest, AnUnfinishedStudyIsSummedUpWithAWarning) {
  Study study = small_study(1000);
  std::vector<double>& speeds = std::get<study::Levels>(study.factors[0].spread).values;
  for (std::size_t i = 0; i < speeds.size(); ++i) speeds[i] = made_up_row(i).factors[0];
  Store store = Store::open_for(study, file("begun.db"));
  store.write_batch(2, made_up_batch(store, 2));
  const study::StudyAnswers answers =
      study::study_answers(store, {.responses = {"peak_force"}, .limits = {}});
  EXPECT_EQ(answers.records.rows.front(), 2 * store.batch_size());
  EXPECT_THAT(told(answers), ::testing::HasSubstr("NOT COMPLETE"));
  EXPECT_THROW(study::study_answers(store, {.responses = {"hic51"}, .limits = {}}), std::invalid_argument);
}

}  // namespace
}  // namespace dashpad::test
