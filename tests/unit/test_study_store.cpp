// The store of a study: what is written comes back, and nothing else is believed.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/mount.h>
#include <sys/resource.h>
#include <unistd.h>

#include <bit>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <optional>
#include <string>

#include "dashpad/study/store.hpp"
#include "shared/temporary_folder.hpp"
#include "small_study.hpp"

namespace dashpad::test {
namespace {

using study::Store;
using study::StoredRow;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// The message of the std::runtime_error that `action` ends with.
template <class Action>
std::string message_of(Action action) {
  try {
    action();
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "nothing was thrown";
}

void expect_same(const StoredRow& got, const StoredRow& expected) {
  EXPECT_EQ(got.row, expected.row);
  EXPECT_EQ(got.factors, expected.factors);
  EXPECT_EQ(got.outcome.status, expected.outcome.status);
  EXPECT_EQ(got.outcome.extrapolated, expected.outcome.extrapolated);
  EXPECT_EQ(got.outcome.bottomed, expected.outcome.bottomed);
  EXPECT_EQ(got.outcome.error, expected.outcome.error);
  ASSERT_EQ(got.outcome.values.size(), expected.outcome.values.size());
  for (std::size_t i = 0; i < got.outcome.values.size(); ++i)
    EXPECT_EQ(std::bit_cast<std::uint64_t>(got.outcome.values[i]),
              std::bit_cast<std::uint64_t>(expected.outcome.values[i]))
        << got.row;
}

class StudyStore : public ::testing::Test {
 protected:
  [[nodiscard]] std::filesystem::path file() const { return folder_.path() / "study.db"; }
  [[nodiscard]] std::vector<std::string> files() const {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(folder_.path()))
      names.push_back(entry.path().filename());
    return names;
  }
  void make(const study::Study& study = small_study()) const {
    Store store = Store::open_for(study, file());
    fill(store);
  }
  [[nodiscard]] std::string refusal(const study::Study& study = small_study()) const {
    return message_of([&] { Store::open_for(study, file()); });
  }
  [[nodiscard]] std::string refusal_to_read() const {
    return message_of([&] {
      const Store store = Store::open_to_read(file());
      (void)store.missing_batches();
      (void)store.column("peak_force");
      store.visit_rows([](const StoredRow&) {});
    });
  }
  test::TemporaryFolder folder_;
};

TEST_F(StudyStore, gives_back_what_was_written_to_the_last_bit) {
  make();
  const Store store = Store::open_to_read(file());
  EXPECT_EQ(store.rows(), 1000U);
  EXPECT_EQ(store.rows_done(), 1000U);
  EXPECT_THAT(store.missing_batches(), IsEmpty());
  EXPECT_EQ(store.study_text(), "title = \"Speeds\"\n");
  EXPECT_EQ(store.factors().at(0).unit, "m/s");
  EXPECT_EQ(store.responses().at(1).name, "rebound_speed");
  std::uint64_t number = 0;
  store.visit_rows([&](const StoredRow& row) { expect_same(row, made_up_row(number++)); });
  EXPECT_EQ(number, 1000U);
  expect_same(store.row(999).value(), made_up_row(999));
  EXPECT_FALSE(store.row(1000).has_value());
  const std::vector<double> rebound = store.column("rebound_speed");
  ASSERT_EQ(rebound.size(), 1000U);
  EXPECT_TRUE(std::isnan(rebound[7]));
  EXPECT_EQ(rebound[8], made_up_row(8).outcome.values[1]);
  EXPECT_THROW((void)store.column("no such"), std::invalid_argument);
}

TEST_F(StudyStore, goes_on_where_it_was_left) {
  const study::Study study = small_study();
  {
    Store store = Store::open_for(study, file());
    const auto all = store.missing_batches();
    ASSERT_EQ(all.size(), (1000 + store.batch_size() - 1) / store.batch_size());
    store.write_batch(3, made_up_batch(store, 3));
    store.write_batch(0, made_up_batch(store, 0));
    store.write_batch(all.back(), made_up_batch(store, all.back()));
  }
  EXPECT_THAT(files(), ElementsAre("study.db")) << "closed, it is one plain file";
  Store store = Store::open_for(study, file());
  const auto missing = store.missing_batches();
  EXPECT_EQ(missing.size(), (1000 + store.batch_size() - 1) / store.batch_size() - 3);
  EXPECT_EQ(missing.at(0), 1U);
  EXPECT_EQ(missing.at(2), 4U);
  EXPECT_FALSE(store.row(store.batch_size()).has_value());
  EXPECT_TRUE(store.row(0).has_value());
}

TEST_F(StudyStore, takes_a_batch_whole_or_not_at_all) {
  Store store = Store::open_for(small_study(), file());
  auto rows = made_up_batch(store, 1);
  store.write_batch(1, rows);
  EXPECT_THROW(store.write_batch(1, rows), std::runtime_error) << "twice";
  EXPECT_THROW(store.write_batch(2, rows), std::invalid_argument) << "rows of another batch";
  rows.pop_back();
  EXPECT_THROW(store.write_batch(2, rows), std::invalid_argument) << "a row short";
  EXPECT_THROW(store.write_batch(1'000'000, {}), std::invalid_argument);
  EXPECT_EQ(store.rows_done(), store.batch_size());
  EXPECT_EQ(store.column("row").size(), store.batch_size());
}

TEST_F(StudyStore, of_another_study_is_refused_and_left_alone) {
  make();
  study::Study other = small_study();
  other.text += "# another\n";
  EXPECT_THAT(refusal(other), AllOf(HasSubstr(file().string()), HasSubstr("a different study")));
  other = small_study();
  other.base.pad.thickness = 0.06;
  EXPECT_THAT(refusal(other), HasSubstr("has since changed"));
  EXPECT_FALSE(Store::open_to_read(file()).is_of(other));
  EXPECT_TRUE(Store::open_to_read(file()).is_of(small_study()));
  edit(file(), "UPDATE study SET value = '0.0.1 (abc)' WHERE key = 'program'");
  EXPECT_THAT(refusal(), AllOf(HasSubstr("Dashpad 0.0.1 (abc) computed the existing 1000 of 1000 rows"),
                               HasSubstr("give another name or delete the file")));
  EXPECT_EQ(Store::open_to_read(file()).rows_done(), 1000U);
}

TEST_F(StudyStore, has_one_writer) {
  const Store store = Store::open_for(small_study(), file());
  EXPECT_THAT(refusal(), HasSubstr("another run is writing to it"));
}

TEST_F(StudyStore, is_read_while_it_is_written) {
  {
    Store store = Store::open_for(small_study(), file());
    store.write_batch(0, made_up_batch(store, 0));
    const Store reader = Store::open_to_read(file());
    store.write_batch(1, made_up_batch(store, 1));
    EXPECT_EQ(reader.rows_done(), store.batch_size());
    EXPECT_EQ(reader.column("row").size(), store.batch_size()) << "what was there when it was opened";
    EXPECT_EQ(Store::open_to_read(file()).column("row").size(), 2 * store.batch_size());
    EXPECT_THAT(refusal(), HasSubstr("another run is writing to it"))
        << "also after a reader has closed the file";
  }
  EXPECT_THAT(files(), ElementsAre("study.db"));
}

TEST_F(StudyStore, with_a_reader_at_its_end_loses_nothing) {
  {
    std::optional<Store> store = Store::open_for(small_study(), file());
    store->write_batch(0, made_up_batch(*store, 0));
    const Store reader = Store::open_to_read(file());
    store->write_batch(1, made_up_batch(*store, 1));
    store.reset();
    EXPECT_EQ(reader.column("row").size(), reader.batch_size());
  }
  Store store = Store::open_for(small_study(), file());
  EXPECT_EQ(store.rows_done(), 2 * store.batch_size());
}

/// A folder in the place of FILE-shm: as on a disk without memory that processes share.
TEST_F(StudyStore, without_shared_memory_is_written_all_the_same) {
  std::filesystem::create_directory(file().string() + "-shm");
  {
    Store store = Store::open_for(small_study(), file());
    fill(store);
    EXPECT_THAT(refusal(), HasSubstr("another run is writing to it"));
    EXPECT_THAT(refusal_to_read(), HasSubstr("another program has the file open"));
  }
  EXPECT_EQ(Store::open_to_read(file()).rows_done(), 1000U);
}

TEST_F(StudyStore, of_another_kind_is_refused_and_left_alone) {
  folder_.write("study.db", std::string(5000, 'x'));
  EXPECT_THAT(refusal(), HasSubstr("not the store"));
  EXPECT_THAT(refusal_to_read(), HasSubstr("not the store"));
  EXPECT_EQ(std::filesystem::file_size(file()), 5000U);
  std::filesystem::remove(file());
  edit(file(), "CREATE TABLE mine (x); INSERT INTO mine VALUES (1)");
  EXPECT_THAT(refusal(), HasSubstr("not the store"));
  edit(file(), "SELECT x FROM mine");
  std::filesystem::remove(file());
  make();
  edit(file(), "PRAGMA user_version = 7");
  EXPECT_THAT(refusal(), HasSubstr("layout 7"));
  EXPECT_THAT(refusal_to_read(), HasSubstr("layout 7"));
}

TEST_F(StudyStore, that_is_missing_or_has_no_place_is_refused) {
  EXPECT_THAT(refusal_to_read(), HasSubstr("no such file"));
  EXPECT_THAT(message_of([&] { Store::open_for(small_study(), folder_.path() / "no" / "s.db"); }),
              HasSubstr("no folder"));
  EXPECT_THAT(message_of([&] { Store::open_for(small_study(), folder_.path()); }), HasSubstr("not a file"));
  EXPECT_THAT(message_of([&] { Store::open_for(small_study(), "/dev/null"); }), HasSubstr("not a file"));
  EXPECT_THAT(files(), IsEmpty());
  folder_.write("study.db", "");
  EXPECT_THAT(refusal_to_read(), HasSubstr("empty"));
  make();
  EXPECT_EQ(Store::open_to_read(file()).rows_done(), 1000U) << "an empty file is room for a store";
}

/// Root may write everywhere: "nobody" may not.
class WithoutRights {
 public:
  WithoutRights() : user_(::geteuid()) {
    if (user_ == 0) changed_ = ::seteuid(65534) == 0;
  }
  ~WithoutRights() {
    if (changed_ && ::seteuid(user_) != 0) std::abort();
  }
  WithoutRights(const WithoutRights&) = delete;
  WithoutRights& operator=(const WithoutRights&) = delete;

 private:
  uid_t user_;
  bool changed_ = false;
};

TEST_F(StudyStore, that_is_read_only_can_be_read_and_not_be_written) {
  namespace fs = std::filesystem;
  make();
  fs::permissions(file(), fs::perms::owner_read | fs::perms::group_read | fs::perms::others_read);
  fs::permissions(folder_.path(), fs::perms::owner_write | fs::perms::others_write, fs::perm_options::remove);
  {
    const WithoutRights nobody;
    EXPECT_THAT(refusal(), AllOf(HasSubstr(file().string()), HasSubstr("read-only")));
    EXPECT_EQ(Store::open_to_read(file()).rows_done(), 1000U);
    EXPECT_THAT(message_of([&] { Store::open_for(small_study(), folder_.path() / "new.db"); }),
                HasSubstr("the folder is read-only"));
  }
  fs::permissions(folder_.path(), fs::perms::owner_all);
  EXPECT_THAT(files(), ElementsAre("study.db"));
}

TEST_F(StudyStore, that_a_kill_left_has_all_batches_written) {
  const std::filesystem::path copy = folder_.path() / "copy.db";
  Store store = Store::open_for(small_study(), file());
  store.write_batch(0, made_up_batch(store, 0));
  store.write_batch(4, made_up_batch(store, 4));
  std::filesystem::copy_file(file(), copy);
  std::filesystem::copy_file(file().string() + "-wal", copy.string() + "-wal");
  EXPECT_EQ(Store::open_to_read(copy).rows_done(), 2 * store.batch_size());
  Store again = Store::open_for(small_study(), copy);
  EXPECT_EQ(again.rows_done(), 2 * store.batch_size());
  EXPECT_EQ(again.missing_batches().at(3), 5U);
}

/// Each is a change that no Dashpad makes.
class DamagedStore : public StudyStore, public ::testing::WithParamInterface<const char*> {};

TEST_P(DamagedStore, is_noticed) {
  make();
  ASSERT_EQ(refusal_to_read(), "nothing was thrown");
  edit(file(), GetParam());
  EXPECT_THAT(refusal_to_read(), AllOf(HasSubstr(file().string()), HasSubstr("damaged")));
}

INSTANTIATE_TEST_SUITE_P(
    All, DamagedStore,
    ::testing::Values(
        "DELETE FROM samples WHERE row = 5", "DELETE FROM batches WHERE batch = 1",
        "UPDATE samples SET row = 1000 WHERE row = 5", "UPDATE samples SET row = -1 WHERE row = 5",
        "UPDATE batches SET batch = 5000 WHERE batch = 1",
        "UPDATE samples SET peak_force = 'x' WHERE row = 5", "UPDATE samples SET status = 'x' WHERE row = 5",
        "UPDATE samples SET bottomed = 2 WHERE row = 5", "DROP TABLE batches",
        "DROP TABLE samples; CREATE TABLE samples (row INTEGER PRIMARY KEY)",
        "ALTER TABLE samples RENAME TO kept; CREATE VIEW samples AS SELECT * FROM kept",
        "DELETE FROM study WHERE key = 'rows'", "UPDATE study SET value = 'many' WHERE key = 'rows'",
        "UPDATE study SET value = -1 WHERE key = 'rows'",
        "UPDATE study SET value = 0 WHERE key = 'batch_size'",
        "UPDATE study SET value = 10 WHERE key = 'rows'", "DELETE FROM factors",
        "UPDATE responses SET position = 7 WHERE position = 1",
        "UPDATE samples SET peak_force = 9e999 WHERE row = 5",
        "UPDATE samples SET peak_force = -1e-300 WHERE row = 5",
        "UPDATE samples SET rebound_speed = -2 WHERE row = 5",
        "UPDATE samples SET \"impactor.speed\" = -9e999 WHERE row = 5",
        "UPDATE samples SET \"impactor.speed\" = NULL WHERE row = 5",
        "UPDATE samples SET error = -1e-9 WHERE row = 5", "UPDATE samples SET error = NULL WHERE row = 5",
        "UPDATE study SET value = value || char(27) WHERE key = 'program'",
        "UPDATE factors SET unit = char(27) || '[2J'", "UPDATE responses SET meaning = 'a' || char(10)",
        "UPDATE responses SET unit = char(155) || '2J'"));

/// An estimate may be infinite: a pulse with too few samples to tell.
TEST_F(StudyStore, takes_an_unknown_error) {
  make();
  edit(file(), "UPDATE samples SET error = 9e999 WHERE row = 5");
  EXPECT_EQ(refusal_to_read(), "nothing was thrown");
}

/// A column by itself is judged, too.
TEST_F(StudyStore, has_no_column_with_a_number_that_cannot_be) {
  make();
  edit(file(), "UPDATE samples SET peak_force = -1 WHERE row = 5");
  const Store store = Store::open_to_read(file());
  EXPECT_THAT(message_of([&] { (void)store.column("peak_force"); }), HasSubstr("peak_force = -1"));
  EXPECT_NO_THROW((void)store.column("rebound_speed"));
}

TEST_F(StudyStore, that_is_deleted_or_replaced_while_it_is_written_is_noticed) {
  namespace fs = std::filesystem;
  for (const bool replaced : {false, true}) {
    {
      Store store = Store::open_for(small_study(), file());
      EXPECT_NO_THROW(store.check_in_place());
      store.write_batch(0, made_up_batch(store, 0));
      if (replaced) {
        folder_.write("other", "another file");
        fs::rename(folder_.path() / "other", file());
      } else {
        fs::remove(file());
      }
      const auto said = AllOf(HasSubstr(file().string()), HasSubstr("deleted, renamed or replaced"));
      EXPECT_THAT(message_of([&] { store.check_in_place(); }), said);
      EXPECT_THAT(message_of([&] { store.write_batch(1, made_up_batch(store, 1)); }), said);
      fs::remove(file().string() + "-wal");
      folder_.write("study.db-wal", "of another program");
    }
    EXPECT_TRUE(fs::exists(file().string() + "-wal")) << "the log of that name may be another's";
    for (const std::string& name : files()) fs::remove(folder_.path() / name);
  }
}

TEST_F(StudyStore, that_is_cut_short_is_noticed) {
  make();
  std::filesystem::resize_file(file(), std::filesystem::file_size(file()) / 2);
  EXPECT_THAT(refusal_to_read(), HasSubstr("damaged"));
}

/// A limit on file sizes stands in for a full disk.
class FullDisk {
 public:
  explicit FullDisk(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    ::getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{bytes, before_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FullDisk() {
    ::setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }
  FullDisk(const FullDisk&) = delete;
  FullDisk& operator=(const FullDisk&) = delete;

 private:
  rlimit before_{};
  void (*handler_)(int);
};

TEST_F(StudyStore, on_a_full_disk_keeps_what_is_there) {
  constexpr std::size_t rows = 20'000;
  std::uint64_t kept = 0;
  {
    Store store = Store::open_for(small_study(rows), file());
    const FullDisk full{600'000};
    const std::string message = message_of([&] { fill(store); });
    EXPECT_THAT(message, AllOf(HasSubstr(file().string()), HasSubstr("all rows written so far are kept")));
    kept = store.rows_done();
  }
  EXPECT_GT(kept, 0U);
  EXPECT_LT(kept, rows);
  Store store = Store::open_for(small_study(rows), file());
  EXPECT_EQ(store.rows_done(), kept);
  fill(store);
  EXPECT_EQ(store.rows_done(), rows);
}

/// A small disk in memory.
class SmallDisk {
 public:
  SmallDisk(std::filesystem::path place, std::uintmax_t bytes) : place_(std::move(place)) {
    std::filesystem::create_directory(place_);
    const std::string size = "size=" + std::to_string(bytes);
    mounted_ = ::mount("tmpfs", place_.c_str(), "tmpfs", 0, size.c_str()) == 0;
  }
  ~SmallDisk() {
    if (mounted_) ::umount2(place_.c_str(), MNT_DETACH);
  }
  SmallDisk(const SmallDisk&) = delete;
  SmallDisk& operator=(const SmallDisk&) = delete;
  /// False where this user may not mount.
  [[nodiscard]] bool is_mounted() const { return mounted_; }
  [[nodiscard]] std::filesystem::path file() const { return place_ / "study.db"; }
  [[nodiscard]] std::uintmax_t available() const { return std::filesystem::space(place_).available; }
  /// Takes room until `bytes` are left.
  void leave(std::uintmax_t bytes) const {
    std::filesystem::remove(place_ / "ballast");
    const std::uintmax_t now = available();
    std::ofstream(place_ / "ballast") << std::string(now > bytes ? now - bytes : 0, 'x');
  }

 private:
  std::filesystem::path place_;
  bool mounted_ = false;
};

/// Whatever the room: refused before it starts, with nothing left behind, or written to its end.
TEST_F(StudyStore, on_a_nearly_full_disk_is_finished_or_refused_before_it_starts) {
  for (const std::size_t rows : {500U, 2000U, 20'000U}) {
    int refused = 0, finished = 0;
    for (std::uintmax_t bytes = 128 << 10; bytes < 3 << 20; bytes += bytes / 7) {
      const SmallDisk disk{folder_.path() / "disk", bytes};
      if (!disk.is_mounted()) GTEST_SKIP() << "this user may not mount a disk";
      const std::string message = message_of([&] {
        Store store = Store::open_for(small_study(rows), disk.file());
        EXPECT_NO_THROW(fill(store)) << rows << " rows on " << bytes << " bytes";
      });
      if (message == "nothing was thrown") {
        ++finished;
        EXPECT_EQ(Store::open_to_read(disk.file()).rows_done(), rows);
        EXPECT_FALSE(std::filesystem::exists(disk.file().string() + "-wal"));
      } else {
        ++refused;
        EXPECT_THAT(message, HasSubstr("MB is free"));
        EXPECT_FALSE(std::filesystem::exists(disk.file()));
      }
    }
    EXPECT_GT(refused, 0) << rows;
    EXPECT_GT(finished, 0) << rows;
  }
}

/// Others take the room while it runs, or before it goes on: it needs little more than its rows.
TEST_F(StudyStore, writes_its_log_back_when_the_disk_fills) {
  constexpr std::size_t rows = 20'000;
  constexpr std::uintmax_t of_rows = 1'540'000, of_batches = 400'000;  // 77 bytes a row; the shortest log
  for (const bool opened_again : {false, true}) {
    const SmallDisk disk{folder_.path() / "disk", 40 << 20};
    if (!disk.is_mounted()) GTEST_SKIP() << "this user may not mount a disk";
    std::optional<Store> store = Store::open_for(small_study(rows), disk.file());
    const std::vector<std::uint64_t> batches = store->missing_batches();
    const std::size_t half = batches.size() / 2;
    for (std::size_t i = 0; i < half; ++i) store->write_batch(i, made_up_batch(*store, i));
    const std::string log = disk.file().string() + "-wal";
    EXPECT_GT(std::filesystem::file_size(log), 1'000'000U) << "with room, the log is long";
    if (opened_again) {
      store.reset();
      disk.leave(of_rows / 4);
      EXPECT_THAT(message_of([&] { Store::open_for(small_study(rows), disk.file()); }),
                  HasSubstr("MB is free"));
      disk.leave(of_rows / 2 + of_batches + (64 << 10));
      store = Store::open_for(small_study(rows), disk.file());
    } else {
      disk.leave(of_rows / 2 + of_batches);
    }
    ASSERT_NO_THROW(fill(*store)) << opened_again;
    EXPECT_EQ(store->rows_done(), rows);
  }
}

TEST_F(StudyStore, that_does_not_fit_the_disk_is_refused_before_work_starts) {
  study::Study study = small_study(1000);
  study.responses.clear();
  study.factors.push_back({.key = "pad.thickness",
                           .unit = "m",
                           .spread = study::Uniform{0.04, 0.06},
                           .lowest = {},
                           .highest = {}});
  study.sampling = study::Sampling::monte_carlo;
  study.samples = 1'000'000;
  for (const ResultQuantity& kind : study::response_kinds()) study.responses.emplace_back(kind.key);
  if (static_cast<double>(std::filesystem::space(folder_.path()).available) >
      1e9 * 9.0 * static_cast<double>(study.responses.size()))
    GTEST_SKIP() << "this disk holds every study";
  EXPECT_THAT(refusal(study), HasSubstr("MB is free"));
  EXPECT_THAT(files(), IsEmpty());
}

}  // namespace
}  // namespace dashpad::test
