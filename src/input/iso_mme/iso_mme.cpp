#include "dashpad/input/iso_mme/iso_mme.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <span>

#include <fmt/format.h>

#include "dashpad/input/fault.hpp"
#include "dashpad/quantities/quantity.hpp"
#include "input/iso_mme/test_files.hpp"
#include "input/measurement/clock_time.hpp"
#include "input/measurement/csv_table.hpp"
#include "input/measurement/pulse_samples.hpp"
#include "input/spelling.hpp"
#include "quantities/from_chars.hpp"
#include "quantities/magnitude_bounds.hpp"
#include "quantities/text.hpp"

namespace dashpad::input {
namespace {

using Channels = std::vector<IsoMmeChannel>;

constexpr std::size_t code_length = 16;
constexpr std::size_t place_of_dimension = 12, place_of_direction = 14;

/// "3" and "003" are 3. A code is no number, even if it has digits only.
std::optional<int> channel_number(const std::string& text) {
  return text.size() < code_length ? parsed<int>(text) : std::nullopt;
}

struct Times {
  std::vector<double> all = {};  ///< s; NaN at the ends where they are not known
  std::string counts_from = {};  ///< the first time as in the file, if they count from there
  std::string name = "implicit";
  bool has_no_first = false;  ///< the first time is not stated, and taken as 0
};

bool increase(std::span<const double> times) {
  return std::ranges::adjacent_find(times, std::greater_equal<>()) == times.end() &&
         (times.empty() || std::isfinite(times.back()));
}

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

/// Even times, "implicit": those with a first sample and an interval.
Times even_times(const MmeLabels& labels, std::size_t count, MeasurementFaults& faults) {
  const MmeLabel* const of_first = labels.find("Time of first sample");
  const bool has_no_first = of_first == nullptr || of_first->value.empty();
  const auto first = has_no_first ? std::optional{0.0} : number_of(labels, "Time of first sample", faults);
  const auto interval = number_of(labels, "Sampling interval", faults);
  Times times{.has_no_first = has_no_first};
  if (!first || !interval) return times;
  const MmeLabel* label = labels.find("Sampling interval");
  const bool is_far = *interval >= measured_magnitudes("s").least &&
                      counts_from_first(*first, *interval * static_cast<double>(count));
  if (is_far) times.counts_from = of_first->value + " s";
  for (std::size_t i = 0; i < count; ++i)
    times.all.push_back((is_far ? 0 : *first) + *interval * static_cast<double>(i));
  if (!(*interval > 0))
    faults.add(label->line, label->name, label->value, "must be more than 0");
  else if (!increase(times.all))
    faults.add(label->line, label->name, label->value, "does not give increasing times");
  return times;
}

/// The channel of times that `labels` refer to: by its code, or the only one of times (TI).
const IsoMmeChannel* channel_of_times(const MmeLabels& labels, const Channels& all) {
  const std::string code = upper_case(labels.value("Reference channel name"));
  const IsoMmeChannel* found = nullptr;
  for (const IsoMmeChannel& channel : all) {
    const bool has_times = channel.code.size() == code_length &&
                           upper_case(channel.code).compare(place_of_dimension, 2, "TI") == 0;
    if (code.empty() ? !has_times : upper_case(channel.code) != code) continue;
    if (found != nullptr) return nullptr;
    found = &channel;
  }
  return found;
}

/// The times in another channel, "explicit".
Times explicit_times(const MmeLabels& labels, std::size_t count, const MmeTestFiles& test,
                     const Channels& all, MeasurementFaults& faults) {
  const MmeLabel* const reference = labels.find("Reference channel");
  const IsoMmeChannel* const channel = channel_of_times(labels, all);
  if (channel == nullptr || !channel->problem.empty()) {
    const std::string name = labels.value("Reference channel name");
    faults.add(reference->line, reference->name, reference->value,
               name.empty() ? "needs a time channel: no Reference channel name is given, and there is not "
                              "exactly one time channel (TI)"
                            : fmt::format("the time channel, {}, is missing or occurs twice", name));
    return {};
  }
  const std::string& file = test.channels.at(channel->number);
  MeasurementFaults own(test.shown(file));
  const std::string text = test.texts({file}, false).at(file);
  MmeChannelText read = read_mme_channel(text, own);
  const std::string unit = read.labels.value("Unit").empty() ? "s" : read.labels.value("Unit");
  double factor = 1;
  try {
    factor = pulse_unit_factor(ColumnKind::time, unit);
  } catch (const UnitError& error) {
    own.add(read.labels.find("Unit")->line, "Unit", unit, error.what());
  }
  if (own.none() && read.values.size() != count)
    own.add(0, "", "", fmt::format("has {} times for {} samples", read.values.size(), count));
  own.throw_if_any();
  const std::span<const double> known = std::span(read.values).subspan(read.begin, read.end - read.begin);
  if (!increase(known)) own.refuse(0, "", "", "has times that do not increase");
  Times times{.all = std::move(read.values), .name = channel->code};
  const double first = known.empty() ? 0 : times.all[read.begin];
  const double last = known.empty() ? 0 : times.all[read.end - 1];
  const bool is_far = counts_from_first(factor * first, factor * (last - first));
  if (is_far) times.counts_from = fmt::format("{} {}", first, unit);
  for (double& time : times.all) time = factor * (time - (is_far ? first : 0));
  return times;
}

Times times_of(const MmeLabels& labels, std::size_t count, const MmeTestFiles& test, const Channels& all,
               MeasurementFaults& faults) {
  const std::string kind = lower_case(labels.value("Reference channel"));
  if (kind == "explicit") return explicit_times(labels, count, test, all, faults);
  if (kind.empty() || kind == "implicit") return even_times(labels, count, faults);
  const MmeLabel* const reference = labels.find("Reference channel");
  faults.add(reference->line, reference->name, reference->value, "must be implicit or explicit");
  return {};
}

/// What is read of the channels, and the samples that all of them have.
struct ReadChannels {
  Times times = {};
  std::vector<std::vector<double>> values = {};  ///< m/s2
  std::size_t begin = 0, end = 0;
};

/// Reads a channel: its values, or a direction of a resultant. The first one sets the times.
void read_channel(const IsoMmeChannel& channel, const MmeTestFiles& test, const Channels& all,
                  const PulseOptions& options, ReadChannels& channels, injury::MeasuredPulse& result) {
  const std::string& file = test.channels.at(channel.number);
  MeasurementFaults faults(test.shown(file));
  const std::string text = test.texts({file}, false).at(file);
  MmeChannelText read = read_mme_channel(text, faults);
  Times times = times_of(read.labels, read.values.size(), test, all, faults);
  if (faults.none() && read.end - read.begin < 2) faults.add(0, "", "", "a pulse needs at least two samples");
  injury::MeasuredColumn column{
      .name = channel.code, .number = channel.number, .unit = read.labels.value("Unit")};
  const std::string unit_of_file = column.unit;
  const std::string rule =
      settle_unit(column, ColumnKind::acceleration, options.acceleration_unit, "--acceleration-unit",
                  sensitivity_at(options.sensitivity, result.acceleration.size()));
  const MmeLabel* label = read.labels.find("Unit");
  if (!rule.empty()) faults.add(label == nullptr ? 0 : label->line, "Unit", unit_of_file, rule);
  const auto are_equal = [](double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); };
  if (result.acceleration.empty()) {
    channels.times = std::move(times);
    channels.end = read.values.size();
  } else if (!std::ranges::equal(times.all, channels.times.all, are_equal)) {
    faults.add(0, "", "", "has different times from " + result.acceleration.front().name);
  }
  faults.throw_if_any();
  if (const auto remark = overruled_unit(column, unit_of_file)) result.remarks.push_back(*remark);
  if (const std::string code = read.labels.value("Channel code"); !code.empty() && code != channel.code)
    result.remarks.push_back(fmt::format("{}: the code in its file is {}", channel.code, code));
  for (double& value : read.values) value *= column.factor;
  channels.values.push_back(std::move(read.values));
  channels.begin = std::max(channels.begin, read.begin);
  channels.end = std::min(channels.end, read.end);
  result.acceleration.push_back(column);
}

/// The pulse of the samples that all channels and their times have, and remarks on what they lack.
void assemble(ReadChannels channels, const PulseOptions& options, MeasurementFaults& faults,
              injury::MeasuredPulse& result) {
  Times& times = channels.times;
  const std::size_t count = times.all.size();
  while (channels.begin < channels.end && std::isnan(times.all[channels.begin])) ++channels.begin;
  while (channels.begin < channels.end && std::isnan(times.all[channels.end - 1])) --channels.end;
  if (channels.end < channels.begin + 2) faults.refuse(0, "", "", "a pulse needs at least two samples");
  const auto left_out = [&](std::string_view which, std::size_t samples) {
    if (samples > 0)
      result.remarks.push_back(
          samples == 1
              ? fmt::format("the {} sample has no value (NOVALUE) and was left out", which)
              : fmt::format("the {} {} samples have no value (NOVALUE) and were left out", which, samples));
  };
  left_out("first", channels.begin);
  left_out("last", count - channels.end);
  if (times.has_no_first)
    result.remarks.emplace_back("the time of the first sample is not stated; it is taken as 0");
  if (!times.counts_from.empty()) result.remarks.push_back(remark_on_clock(times.counts_from));
  result.counts_from = times.counts_from;
  result.time.name = times.name;
  const KeptSamples with_value{channels.begin, channels.end};
  with_value.keep(times.all);
  KeptSamples kept{0, times.all.size()};
  if (options.cut.from || options.cut.to) kept = kept_samples(times.all, options.cut, faults, result.remarks);
  kept.keep(times.all);
  for (std::vector<double>& values : channels.values) {
    with_value.keep(values);
    kept.keep(values);
  }
  result.pulse.time = std::move(times.all);
  result.pulse.acceleration =
      options.resultant ? injury::resultant_of(channels.values) : channels.values.front();
  if (options.resultant) result.components = std::move(channels.values);
  if (!std::ranges::all_of(result.pulse.acceleration, [](double value) { return std::isfinite(value); }))
    faults.refuse(0, "", "", "contains a value that is too large to compute with");
  judge_pulse(result.pulse, 0, faults);
  if (faults.none())
    judge_gaps(result.pulse.time, {}, times.name, options.bridge_gaps, faults, result.remarks);
  faults.throw_if_any();
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
        file, fmt::format("--channel {}: must be a number or a code of {} characters, in which ? stands for "
                          "any character",
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
    refuse_file(file, fmt::format("a resultant needs two or three directions (X, Y, Z); available: {}",
                                  found.empty() ? "none" : listing(found)));
  if (!is_one_place || has_double)
    refuse_file(file,
                fmt::format("several resultants are possible: {}; choose one with --channel, such as {}",
                            listing(found), place(found.front())));
  return found;
}

/// The chosen channel, or the directions of a resultant. Throws an InputError that lists the candidates.
/// `file` is for messages.
Channels chosen_channels(const std::filesystem::path& file, const Channels& all,
                         const PulseOptions& options) {
  Channels found = candidates(file, all, options.channel);
  if (options.resultant) return directions(file, found);
  if (found.size() > 1)
    refuse_file(file, fmt::format("several channels match: {}; choose one with --channel{}", listing(found),
                                  ", or combine the directions of one place with --resultant"));
  return found;
}

}  // namespace

bool is_iso_mme(const std::filesystem::path& file) {
  std::error_code error;
  return std::filesystem::is_directory(file, error) || lower_case(file.extension().string()) == ".mme" ||
         is_archive(file);
}

Reading<std::vector<IsoMmeChannel>> iso_mme_channels(const std::filesystem::path& file,
                                                     const std::string& test) {
  return reading_of([&]() -> std::vector<IsoMmeChannel> { return list(find_mme_test(file, test)); });
}

Reading<PulseFile> read_iso_mme(const std::filesystem::path& file, const PulseOptions& options) {
  return reading_of([&]() -> PulseFile {
    const MmeTestFiles test = find_mme_test(file, options.test);
    injury::MeasuredPulse result{.format = "ISO-MME",
                                 .time = {.name = "implicit", .unit = "s", .unit_origin = "format"},
                                 .resultant = options.resultant};
    const Channels all = list(test);
    const Channels chosen = chosen_channels(file, all, options);
    if (options.sensitivity.size() > 1 && options.sensitivity.size() != chosen.size())
      refuse_file(file, wrong_number_of_sensitivities(options.sensitivity.size(), chosen.size()));
    ReadChannels channels;
    for (const IsoMmeChannel& channel : chosen) {
      if (!channel.problem.empty())
        throw InputError({Fault{file.string(), 0, channel.code, "", channel.problem}});
      read_channel(channel, test, all, options, channels, result);
    }
    MeasurementFaults faults(file.string());
    assemble(std::move(channels), options, faults, result);
    return {std::move(result), test.files()};
  });
}

Reading<PulseFile> read_pulse(const std::filesystem::path& file, const PulseOptions& options) {
  return is_iso_mme(file) ? read_iso_mme(file, options) : read_pulse_csv(file, options);
}

}  // namespace dashpad::input
