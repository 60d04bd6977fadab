// ISO-MME in archives: the same as in folders, and nothing else can be reached or overflow.

#include <archive.h>
#include <archive_entry.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "input/iso_mme/test_files.hpp"
#include "sample_mme.hpp"
#include "shared/gravity.hpp"

namespace dashpad {
namespace {

namespace fs = std::filesystem;
using test::Files;
using test::said;
using test::sample_test;
using test::write;
using ::testing::DoubleEq;
using ::testing::HasSubstr;
using ::testing::Pointwise;
using ::testing::SizeIs;

/// A zip or, with another ending, a gzipped tar of the files, with names just as given.
void pack(const fs::path& file, const std::vector<std::pair<std::string, std::string>>& files,
          const std::string& link_to = "") {
  struct archive* made = ::archive_write_new();
  if (file.extension() == ".zip") {
    ::archive_write_set_format_zip(made);
  } else {
    ::archive_write_set_format_ustar(made);
    ::archive_write_add_filter_gzip(made);
  }
  ASSERT_EQ(::archive_write_open_filename(made, file.c_str()), ARCHIVE_OK);
  for (const auto& [name, text] : files) {
    struct archive_entry* entry = ::archive_entry_new();
    ::archive_entry_set_pathname(entry, name.c_str());
    ::archive_entry_set_perm(entry, 0644);
    const bool is_link = text == "LINK";
    ::archive_entry_set_filetype(entry, is_link ? AE_IFLNK : AE_IFREG);
    if (is_link) ::archive_entry_set_symlink(entry, link_to.c_str());
    ::archive_entry_set_size(entry, is_link ? 0 : static_cast<la_int64_t>(text.size()));
    ASSERT_EQ(::archive_write_header(made, entry), ARCHIVE_OK) << ::archive_error_string(made);
    if (!is_link) ::archive_write_data(made, text.data(), text.size());
    ::archive_entry_free(entry);
  }
  ASSERT_EQ(::archive_write_close(made), ARCHIVE_OK);
  ::archive_write_free(made);
}

void pack(const fs::path& file, const Files& files) {
  pack(file, std::vector<std::pair<std::string, std::string>>(files.begin(), files.end()));
}

TEST(iso_mme_archive, folder_file_zip_and_tar_are_the_same) {
  const test::TemporaryFolder folder;
  const fs::path test = folder.path() / "test";
  write(test, sample_test());
  Files inner, windows;
  for (const auto& [name, text] : sample_test()) {
    inner["v1/" + name] = text;
    std::string other = "V1\\" + name;
    std::replace(other.begin(), other.end(), '/', '\\');
    windows[other] = text;
  }
  inner["__MACOSX/v1/._v1.mme"] = "litter";
  pack(folder.path() / "flat.zip", sample_test());
  pack(folder.path() / "inner.zip", inner);
  pack(folder.path() / "windows.zip", windows);
  pack(folder.path() / "inner.tar.gz", inner);
  for (const fs::path& file : {test, test / "v1.mme", folder.path() / "flat.zip", folder.path() / "inner.zip",
                               folder.path() / "windows.zip", folder.path() / "inner.tar.gz"}) {
    SCOPED_TRACE(file);
    ASSERT_TRUE(input::is_iso_mme(file));
    const auto channels = input::iso_mme_channels(file).value();
    ASSERT_THAT(channels, SizeIs(4));
    EXPECT_EQ(channels[3].code, "11CHST0000H3FOXB");
    EXPECT_EQ(channels[3].unit, "kN");
    EXPECT_EQ(channels[3].samples, "3");
    EXPECT_EQ(channels[3].name, "In words: 11CHST0000H3FOXB");
    for (const std::string wanted : {"1", "001", "11HEAD0000H3ACXA", "??head????h3ACX?"}) {
      const injury::MeasuredPulse measured = input::read_iso_mme(file, {.channel = wanted}).value().measured;
      EXPECT_THAT(measured.pulse.time, Pointwise(DoubleEq(), {-0.001, 0.0, 0.001}));
      EXPECT_THAT(measured.pulse.acceleration, Pointwise(DoubleEq(), {0.0, -3 * g, 2 * g}));
      EXPECT_EQ(measured.acceleration.front().name, "11HEAD0000H3ACXA");
      EXPECT_EQ(measured.acceleration.front().unit, "g");
    }
    for (const std::string wanted : {"", "11HEAD0000??AC?A"}) {
      const injury::MeasuredPulse resultant =
          input::read_iso_mme(file, {.channel = wanted, .resultant = true}).value().measured;
      EXPECT_THAT(resultant.pulse.acceleration, Pointwise(DoubleEq(), {g, 5 * g, 3 * g}));
      EXPECT_THAT(resultant.acceleration, SizeIs(3));
      ASSERT_THAT(resultant.components, SizeIs(3));
      EXPECT_THAT(resultant.components[0], Pointwise(DoubleEq(), {0.0, -3 * g, 2 * g}));
    }
  }
}

TEST(iso_mme_archive, archives_that_lead_elsewhere_are_refused) {
  const test::TemporaryFolder folder;
  const Files files = sample_test();
  const std::vector<std::pair<std::string, std::string>> good(files.begin(), files.end());
  for (const std::string name : {"../v1.001", "a/../../b", "/etc/passwd", "..", "C:\\x", "..\\x"}) {
    for (const std::string ending : {".zip", ".tar.gz"}) {
      SCOPED_TRACE(name + ending);
      auto bad = good;
      bad.emplace_back(name, "x");
      const fs::path file = folder.path() / ("bad" + ending);
      pack(file, bad);
      EXPECT_THAT(said(file, {.channel = "1"}), HasSubstr("which points outside the archive"));
    }
  }
  auto twice = good;
  twice.emplace_back("Channel/v1.001", "x");
  pack(folder.path() / "twice.zip", twice);
  EXPECT_THAT(said(folder.path() / "twice.zip", {.channel = "1"}), HasSubstr("\"Channel/v1.001\" twice"));
  auto link = good;
  for (auto& [name, text] : link)
    if (name == "Channel/v1.001") text = "LINK";
  pack(folder.path() / "link.tar.gz", link, "/etc/passwd");
  EXPECT_THAT(said(folder.path() / "link.tar.gz", {.channel = "1"}), HasSubstr("its file is missing"));

  pack(folder.path() / "cut.zip", sample_test());
  fs::resize_file(folder.path() / "cut.zip", 100);
  EXPECT_THAT(said(folder.path() / "cut.zip", {.channel = "1"}),
              HasSubstr("cannot be unpacked: it is not a zip, tar or gzipped tar, or it is damaged"));
}

TEST(iso_mme_archive, archives_that_unpack_without_end_are_refused) {
  const test::TemporaryFolder folder;
  Files files = sample_test();
  const std::string name = "Channel/v1.001";
  files[name] = std::string(std::size_t{1} << 23, '0');  // packs to a few kilobytes
  for (const std::string ending : {"bomb.zip", "bomb.tar.gz"}) {
    const fs::path bomb = folder.path() / ending;
    pack(bomb, files);
    EXPECT_THAT(input::iso_mme_channels(bomb).value(), SizeIs(4));
    EXPECT_THAT(input::read_from_archive(bomb, {name}, 1000, true).at(name), SizeIs(1000));
    EXPECT_THROW(input::read_from_archive(bomb, {name}, std::size_t{1} << 22, false), input::InputError);
    EXPECT_THAT(input::read_from_archive(bomb, {name}, std::size_t{1} << 23, false).at(name),
                SizeIs(1U << 23));
  }
  Files many = sample_test();
  for (int i = 0; i < 10'001; ++i) many["x" + std::to_string(i)] = "";
  pack(folder.path() / "many.zip", many);
  EXPECT_THAT(said(folder.path() / "many.zip", {.channel = "1"}), HasSubstr("more than 10000 files"));
}

TEST(iso_mme_archive, damaged_archives_are_told) {
  const test::TemporaryFolder folder;
  const auto cut = folder.path() / "cut.zip";
  pack(cut, sample_test());
  fs::resize_file(cut, fs::file_size(cut) / 2);
  EXPECT_THAT(said(cut, {.channel = "1"}), HasSubstr("cannot be unpacked"));
  EXPECT_THAT(said(folder.write("x.gz", "\x1f\x8b\x08 and so on"), {}), HasSubstr("cannot be unpacked"));
}

}  // namespace
}  // namespace dashpad
