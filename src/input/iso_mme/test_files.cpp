#include "input/iso_mme/test_files.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <limits>
#include <optional>
#include <string_view>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "input/disk.hpp"
#include "input/spelling.hpp"
#include "quantities/from_chars.hpp"

namespace dashpad::input {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t beginning = 65536;  // bytes; enough for all labels
constexpr std::size_t max_digits = 5;

/// The parts of a name, without / and point.
struct Name {
  std::string folder, stem, ending;
};
Name parts(const std::string& whole) {
  const auto slash = whole.rfind('/');
  const std::string last = slash == std::string::npos ? whole : whole.substr(slash + 1);
  const auto point = last.rfind('.');
  return {slash == std::string::npos ? "" : whole.substr(0, slash), last.substr(0, point),
          point == std::string::npos ? "" : last.substr(point + 1)};
}

bool are_alike(const std::string& a, const std::string& b) { return lower_case(a) == lower_case(b); }

/// Files that some systems add to archives.
bool is_litter(const std::string& name) {
  return name.starts_with("__MACOSX/") || parts(name).stem.starts_with("._") ||
         (parts(name).stem.empty() && name.find("._") != std::string::npos);
}

std::optional<int> number_of_ending(const std::string& ending) {
  const auto number = parsed<int>(ending);
  const bool fits = ending.size() >= 3 && ending.size() <= max_digits && number && *number > 0;
  return fits ? number : std::nullopt;
}

/// The .mme file called `wanted`, or else that of the test, or else the only one.
std::string main_file(const fs::path& file, const std::vector<std::string>& names, const std::string& wanted,
                      const std::string& test) {
  std::vector<std::string> found, stems;
  for (const std::string& name : names) {
    const Name of = parts(name);
    const bool fits = wanted.empty() ? are_alike(of.ending, "mme") : name == wanted;
    if (!fits || is_litter(name)) continue;
    found.push_back(name);
    stems.push_back(of.stem);
  }
  if (found.empty())
    refuse_file(file, wanted.empty() ? "contains no .mme file, so it is not a test in ISO-MME format"
                                     : "is not a regular file");
  std::vector<std::string> called;
  for (std::size_t i = 0; i < found.size(); ++i)
    if (are_alike(stems[i], test) || are_alike(found[i], test) || are_alike(parts(found[i]).folder, test))
      called.push_back(found[i]);
  if (test.empty() && found.size() == 1) return found.front();
  if (called.size() == 1) return called.front();
  std::ranges::sort(stems);
  const bool are_different = std::ranges::adjacent_find(stems) == stems.end();
  const std::string all = short_listing(are_different ? stems : found);
  if (test.empty())
    refuse_file(file, fmt::format("contains {} tests: {}; choose one with --test", found.size(), all));
  refuse_file(file, fmt::format("--test {}: {}; available: {}", test,
                                called.empty() ? "no such test" : "several tests have this name", all));
}

constexpr std::string_view no_value = "NOVALUE";
constexpr double no_number = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t max_labels = 10'000;

/// Takes a label off; false if `line` is none.
bool take_label(std::string_view line, std::size_t number, MmeLabels& labels) {
  const auto colon = line.find(':');
  if (colon == std::string_view::npos || labels.all().size() == max_labels) return false;
  const std::string value = to_utf8(without_blanks(line.substr(colon + 1)));
  labels.add({to_utf8(without_blanks(line.substr(0, colon))), value == no_value ? "" : value, number});
  return true;
}

void check_number_of_samples(const MmeChannelText& channel, MeasurementFaults& faults) {
  const MmeLabel* label = channel.labels.find("Number of samples");
  if (label == nullptr || label->value.empty()) return;
  const ReadNumber claimed = read_number(label->value);
  if (claimed.kind != NumberKind::number || claimed.value != static_cast<double>(channel.values.size()))
    faults.add(label->line, label->name, label->value,
               fmt::format("must be the number of samples in the file, {}", channel.values.size()));
}

}  // namespace

bool is_archive(const fs::path& file) {
  std::error_code error;
  if (!fs::is_regular_file(file, error)) return false;
  std::array<char, 512> begin{};
  std::ifstream stream(file, std::ios::binary);
  stream.read(begin.data(), begin.size());
  const std::string_view bytes(begin.data(), static_cast<std::size_t>(stream.gcount()));
  const bool is_zip = bytes.starts_with("PK\x03\x04") || bytes.starts_with("PK\x05\x06");
  return is_zip || bytes.starts_with("\x1f\x8b") || (bytes.size() == 512 && bytes.substr(257, 5) == "ustar");
}

std::vector<InputFile> MmeTestFiles::files() const {
  if (in_archive) return {{"the test", source}};
  std::vector<InputFile> all{{"the .mme file of the test", source / main_file}};
  if (!channel_list.empty()) all.push_back({"the channel list of the test", source / channel_list});
  for (const auto& [number, name] : channels) all.push_back({"a channel of the test", source / name});
  return all;
}

MmeMembers MmeTestFiles::texts(const std::vector<std::string>& names, bool only_labels) const {
  const std::size_t most = only_labels ? beginning : largest_measurement;
  return (in_archive ? read_from_archive : read_from_folder)(source, names, most, only_labels);
}

MmeTestFiles find_mme_test(const fs::path& file, const std::string& test_name) {
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  if (status.type() == fs::file_type::not_found) refuse_file(file, "no such file");
  if (error) refuse_file(file, "cannot be read: " + error.message());
  MmeTestFiles test{
      .source = file, .in_archive = is_archive(file), .main_file = {}, .channel_list = {}, .channels = {}};
  std::string wanted;
  if (!is_directory(status) && !test.in_archive) {
    wanted = file.filename().string();
    test.source = file.has_parent_path() ? file.parent_path() : fs::path(".");
  }
  const std::vector<std::string> names =
      test.in_archive ? names_in_archive(test.source) : names_in_folder(test.source);
  test.main_file = main_file(file, names, wanted, test_name);
  const Name main = parts(test.main_file);
  const std::string folder = main.folder.empty() ? "Channel" : main.folder + "/Channel";

  std::vector<std::string> lists;
  for (const std::string& name : names) {
    const Name of = parts(name);
    if (are_alike(of.folder, folder) && are_alike(of.ending, "chn") && !is_litter(name))
      lists.push_back(name);
  }
  if (const auto same = std::ranges::find_if(
          lists, [&](const std::string& name) { return are_alike(parts(name).stem, main.stem); });
      same != lists.end())
    test.channel_list = *same;
  else if (lists.size() == 1)
    test.channel_list = lists.front();

  const std::string stem = test.channel_list.empty() ? main.stem : parts(test.channel_list).stem;
  for (const std::string& name : names) {
    const Name of = parts(name);
    const auto number = number_of_ending(of.ending);
    if (!number || !are_alike(of.folder, folder) || !are_alike(of.stem, stem)) continue;
    if (!test.channels.emplace(*number, name).second)
      refuse_file(file, fmt::format("has channel {} twice", *number));
  }
  if (test.channels.empty())
    refuse_file(file, fmt::format("contains no channels: there is no file {}/{}.001", folder, stem));
  return test;
}

const MmeLabel* MmeLabels::find(std::string_view name) const {
  const std::string wanted = lower_case(name);
  const auto found =
      std::ranges::find_if(labels_, [&](const MmeLabel& label) { return lower_case(label.name) == wanted; });
  return found == labels_.end() ? nullptr : &*found;
}

MmeLabels read_mme_labels(std::string_view text) {
  MmeLabels labels;
  LineReader lines(without_mark(text));
  std::string_view line;
  while (lines.next(line))
    if (!without_blanks(line).empty() && !take_label(line, lines.number(), labels)) break;
  return labels;
}

MmeChannelText read_mme_channel(std::string_view text, MeasurementFaults& faults) {
  MmeChannelText channel;
  LineReader lines(text_in(text, faults));
  std::string_view line;
  bool in_labels = true;
  std::size_t blank_line = 0;
  std::vector<std::pair<std::size_t, std::size_t>> missing;  // sample and line
  while (lines.next(line)) {
    line = without_blanks(line);
    if (line.empty()) {
      if (!in_labels && blank_line == 0) blank_line = lines.number();
      continue;
    }
    if (in_labels && take_label(line, lines.number(), channel.labels)) continue;
    in_labels = false;
    if (blank_line != 0) faults.add(blank_line, "sample", "", rule_for(NumberKind::empty));
    blank_line = 0;
    if (channel.values.size() == max_samples)
      faults.refuse(lines.number(), "", "", fmt::format("there are more than {} samples", max_samples));
    const bool has_value = line != no_value;
    const ReadNumber number = has_value ? read_number(line) : ReadNumber{NumberKind::number, no_number};
    if (number.kind != NumberKind::number) faults.add(lines.number(), "sample", line, rule_for(number.kind));
    if (!has_value) missing.emplace_back(channel.values.size(), lines.number());
    channel.values.push_back(number.value);
  }
  const auto is_there = [](double value) { return !std::isnan(value); };
  const auto begin = std::ranges::find_if(channel.values, is_there);
  const auto end = std::find_if(channel.values.rbegin(), channel.values.rend(), is_there);
  channel.begin = static_cast<std::size_t>(begin - channel.values.begin());
  channel.end = std::max(channel.begin, static_cast<std::size_t>(channel.values.rend() - end));
  std::erase_if(missing, [&](const auto& sample) {
    return sample.first < channel.begin || sample.first >= channel.end;
  });
  if (!missing.empty())
    faults.add(missing.front().second, "sample", no_value,
               fmt::format("is missing between two other samples{}; a pulse must not have gaps",
                           missing.size() == 1 ? "" : fmt::format(" ({} missing in all)", missing.size())));
  check_number_of_samples(channel, faults);
  return channel;
}

}  // namespace dashpad::input
