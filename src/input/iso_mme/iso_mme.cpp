#include "dashpad/input/iso_mme/iso_mme.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "dashpad/input/fault.hpp"
#include "input/iso_mme/test_files.hpp"
#include "input/measurement/csv_table.hpp"
#include "input/measurement/pulse_samples.hpp"
#include "input/spelling.hpp"
#include "quantities/from_chars.hpp"
#include "quantities/magnitude_bounds.hpp"

namespace dashpad::input {
namespace {

using Channels = std::vector<IsoMmeChannel>;

constexpr std::size_t code_length = 16;
constexpr std::size_t place_of_dimension = 12, place_of_direction = 14;

/// "3" and "003" are 3. A code is no number, even if it has digits only.
std::optional<int> channel_number(const std::string& text) {
  return text.size() < code_length ? parsed<int>(text) : std::nullopt;
}

struct EvenTimes {
  double first = 0, interval = 0;
  std::string counts_from = {};  ///< the first time as in the file, if `first` is 0 instead

  [[nodiscard]] double at(std::size_t sample) const { return first + interval * static_cast<double>(sample); }
  friend bool operator==(const EvenTimes&, const EvenTimes&) = default;
  /// False if rounding makes two neighbours equal.
  [[nodiscard]] bool increase(std::size_t count) const {
    for (std::size_t i = 1; i < count; ++i)
      if (!(at(i) > at(i - 1))) return false;
    return std::isfinite(at(count));
  }
};

std::optional<double> number_of(const MmeLabels& labels, const std::string& name, MeasurementFaults& faults) {
  const MmeLabel* label = labels.find(name);
  if (label == nullptr || label->value.empty()) {
    faults.add(label == nullptr ? 0 : label->line, name, "", "is missing");
    return std::nullopt;
  }
  const ReadNumber number = read_number(label->value);
  if (number.kind == NumberKind::number) return number.value;
  faults.add(label->line, label->name, label->value, rule_for(number.kind));
  return std::nullopt;
}

EvenTimes times_of(const MmeLabels& labels, std::size_t count, MeasurementFaults& faults) {
  if (const MmeLabel* reference = labels.find("Reference channel");
      reference != nullptr && !reference->value.empty() && lower_case(reference->value) != "implicit")
    faults.add(reference->line, reference->name, reference->value,
               "only \"implicit\" times are read, those with a first sample and an interval");
  const auto first = number_of(labels, "Time of first sample", faults);
  const auto interval = number_of(labels, "Sampling interval", faults);
  if (!first || !interval) return {};
  const MmeLabel* label = labels.find("Sampling interval");
  EvenTimes times{*first, *interval};
  if (*interval >= measured_magnitudes("s").least &&
      counts_from_first(*first, *interval * static_cast<double>(count)))
    times = {0, *interval, labels.value("Time of first sample") + " s"};
  if (!(*interval > 0))
    faults.add(label->line, label->name, label->value, "must be more than 0");
  else if (!times.increase(count))
    faults.add(label->line, label->name, label->value, "does not give times that increase");
  return times;
}

/// Adds the samples of a channel to the result; `times` if it is the first.
void add_samples(const std::vector<double>& values, const EvenTimes& times,
                 const injury::MeasuredColumn& column, injury::MeasuredPulse& result,
                 MeasurementFaults& faults) {
  Pulse& pulse = result.pulse;
  if (result.acceleration.empty()) {
    result.counts_from = times.counts_from;
    if (!times.counts_from.empty()) result.remarks.push_back(remark_on_clock(times.counts_from));
    for (std::size_t i = 0; i < values.size(); ++i) pulse.time.push_back(times.at(i));
  }
  std::vector<double> scaled(values.size());
  std::ranges::transform(values, scaled.begin(), [&](double value) { return value * column.factor; });
  if (result.resultant) {
    result.components.push_back(std::move(scaled));
    pulse.acceleration = injury::resultant_of(result.components);
  } else {
    pulse.acceleration = std::move(scaled);
  }
  if (!std::ranges::all_of(pulse.acceleration, [](double value) { return std::isfinite(value); }))
    faults.refuse(0, "", "", "holds a value that is too large to compute with");
  judge_pulse(pulse, 0, faults);
  faults.throw_if_any();
  result.acceleration.push_back(column);
}

/// Adds a channel to the result: its values, or a direction of a resultant. The first one sets `first_times`.
void add_channel(const IsoMmeChannel& channel, const MmeTestFiles& test, const IsoMmeOptions& options,
                 EvenTimes& first_times, injury::MeasuredPulse& result) {
  const std::string& file = test.channels.at(channel.number);
  MeasurementFaults faults(test.shown(file));
  const std::string text = test.texts({file}, false).at(file);
  const MmeChannelText read = read_mme_channel(text, faults);
  const EvenTimes times = times_of(read.labels, read.values.size(), faults);
  if (faults.none() && read.values.size() < 2) faults.add(0, "", "", "a pulse needs at least two samples");
  injury::MeasuredColumn column{
      .name = channel.code, .number = channel.number, .unit = read.labels.value("Unit")};
  const std::string unit_of_file = column.unit;
  const std::string rule =
      settle_unit(column, ColumnKind::acceleration, options.acceleration_unit, "--acceleration-unit",
                  sensitivity_at(options.sensitivity, result.acceleration.size()));
  const MmeLabel* label = read.labels.find("Unit");
  if (!rule.empty()) faults.add(label == nullptr ? 0 : label->line, "Unit", unit_of_file, rule);
  if (result.acceleration.empty())
    first_times = times;
  else if (times != first_times || read.values.size() != result.pulse.time.size())
    faults.add(0, "", "", "has different times from " + result.acceleration.front().name);
  faults.throw_if_any();
  if (const auto remark = overruled_unit(column, unit_of_file)) result.remarks.push_back(*remark);
  if (const std::string code = read.labels.value("Channel code"); !code.empty() && code != channel.code)
    result.remarks.push_back(fmt::format("{}: its file has the code {}", channel.code, code));
  add_samples(read.values, times, column, result, faults);
}

/// By channel number, the code and name in "11HEAD0000H3ACXA / Head x".
std::map<int, std::pair<std::string, std::string>> listed_names(const MmeLabels& labels) {
  std::map<int, std::pair<std::string, std::string>> names;
  constexpr std::string_view beginning = "name of channel";
  for (const MmeLabel& label : labels.all()) {
    if (!lower_case(label.name).starts_with(beginning)) continue;
    const auto number = channel_number(std::string(without_blanks(label.name.substr(beginning.size()))));
    const auto slash = label.value.find('/');
    const std::string code(without_blanks(std::string_view(label.value).substr(0, slash)));
    const std::string words =
        slash == std::string::npos ? "" : std::string(without_blanks(label.value.substr(slash + 1)));
    if (number) names.emplace(*number, std::pair{code, words});
  }
  return names;
}

Channels list(const MmeTestFiles& test) {
  std::vector<std::string> names;
  for (const auto& [number, name] : test.channels) names.push_back(name);
  if (!test.channel_list.empty()) names.push_back(test.channel_list);
  const MmeMembers texts = test.texts(names, true);
  auto listed = test.channel_list.empty() ? std::map<int, std::pair<std::string, std::string>>{}
                                          : listed_names(read_mme_labels(texts.at(test.channel_list)));
  Channels channels;
  for (const auto& [number, name] : test.channels) {
    const MmeLabels labels = read_mme_labels(texts.at(name));
    IsoMmeChannel channel{.number = number,
                          .code = labels.value("Channel code"),
                          .name = labels.value("Name of the channel"),
                          .unit = labels.value("Unit"),
                          .samples = labels.value("Number of samples"),
                          .problem = {}};
    if (const auto found = listed.extract(number)) {
      if (channel.code.empty()) channel.code = found.mapped().first;
      if (channel.name.empty()) channel.name = found.mapped().second;
    }
    channels.push_back(std::move(channel));
  }
  for (const auto& [number, words] : listed)
    channels.push_back({number, words.first, words.second, "", "", "its file is missing"});
  std::ranges::sort(channels, {}, &IsoMmeChannel::number);
  return channels;
}

std::string listing(const Channels& channels) {
  std::vector<std::string> all;
  for (const IsoMmeChannel& iso_mme_channel : channels)
    all.push_back(fmt::format("{} ({})", iso_mme_channel.code, iso_mme_channel.number));
  return short_listing(all);
}

bool is_acceleration(const IsoMmeChannel& channel) {
  return channel.code.size() == code_length && channel.code.compare(place_of_dimension, 2, "AC") == 0;
}

bool matches(const std::string& code, const std::string& pattern) {
  return std::ranges::equal(code, pattern, [](char c, char wanted) { return wanted == '?' || c == wanted; });
}

/// The channels that match the user's words, or all accelerations.
Channels candidates(const std::filesystem::path& file, const Channels& all, const std::string& wanted) {
  Channels found;
  const auto number = channel_number(wanted);
  const std::string pattern = upper_case(wanted);
  if (!wanted.empty() && !number && pattern.size() != code_length)
    refuse_file(
        file, fmt::format("--channel {}: a channel is a number or a code of {} characters; ? stands for any "
                          "character",
                          wanted, code_length));
  for (const IsoMmeChannel& channel : all) {
    const bool fits = wanted.empty() ? is_acceleration(channel)
                      : number       ? channel.number == *number
                                     : matches(upper_case(channel.code), pattern);
    if (fits) found.push_back(channel);
  }
  if (found.empty())
    refuse_file(file, fmt::format("{}; available: {}",
                                  wanted.empty() ? "has no acceleration channel (AC)"
                                                 : fmt::format("--channel {}: no such channel", wanted),
                                  listing(all)));
  return found;
}

/// The directions X, Y, Z of one place, or two of them.
Channels directions(const std::filesystem::path& file, Channels found) {
  std::erase_if(found, [](const IsoMmeChannel& channel) {
    return channel.code.size() != code_length ||
           std::string_view("XYZ").find(channel.code[place_of_direction]) == std::string_view::npos;
  });
  const auto place = [](const IsoMmeChannel& channel) {
    std::string code = channel.code;
    code[place_of_direction] = '?';
    return code;
  };
  const auto direction = [](const IsoMmeChannel& channel) { return channel.code[place_of_direction]; };
  std::ranges::sort(found, {}, direction);
  const bool is_one_place = std::ranges::all_of(
      found, [&](const IsoMmeChannel& channel) { return place(channel) == place(found.front()); });
  const bool has_double = std::ranges::adjacent_find(found, {}, direction) != found.end();
  if (found.size() < 2)
    refuse_file(file, fmt::format("a resultant needs two or three of the directions X, Y, Z; there is {}",
                                  found.empty() ? "none" : listing(found)));
  if (!is_one_place || has_double)
    refuse_file(file, fmt::format("several resultants are possible: {}; choose with --channel, such as {}",
                                  listing(found), place(found.front())));
  return found;
}

/// The chosen channel, or the directions of a resultant. Throws an InputError that lists the candidates.
/// `file` is for messages.
Channels chosen_channels(const std::filesystem::path& file, const Channels& all,
                         const IsoMmeOptions& options) {
  Channels found = candidates(file, all, options.channel);
  if (options.resultant) return directions(file, found);
  if (found.size() > 1)
    refuse_file(file, fmt::format("several channels match: {}; choose with --channel{}", listing(found),
                                  ", or combine the directions of one place with --resultant"));
  return found;
}

}  // namespace

bool is_iso_mme(const std::filesystem::path& file) {
  std::error_code error;
  return std::filesystem::is_directory(file, error) || lower_case(file.extension().string()) == ".mme" ||
         is_archive(file);
}

Reading<std::vector<IsoMmeChannel>> iso_mme_channels(const std::filesystem::path& file) {
  return reading_of([&]() -> std::vector<IsoMmeChannel> { return list(find_mme_test(file)); });
}

Reading<PulseFile> read_iso_mme(const std::filesystem::path& file, const IsoMmeOptions& options) {
  return reading_of([&]() -> PulseFile {
    const MmeTestFiles test = find_mme_test(file);
    injury::MeasuredPulse result{.format = "ISO-MME",
                                 .time = {.name = "implicit", .unit = "s", .unit_origin = "format"},
                                 .resultant = options.resultant};
    const Channels chosen = chosen_channels(file, list(test), options);
    if (options.sensitivity.size() > 1 && options.sensitivity.size() != chosen.size())
      refuse_file(file, wrong_number_of_sensitivities(options.sensitivity.size(), chosen.size()));
    EvenTimes first_times;
    for (const IsoMmeChannel& channel : chosen) {
      if (!channel.problem.empty())
        throw InputError({Fault{file.string(), 0, channel.code, "", channel.problem}});
      add_channel(channel, test, options, first_times, result);
    }
    return {std::move(result), test.files()};
  });
}

}  // namespace dashpad::input
