#include "input/iso_mme/text.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "input/text_file.hpp"

namespace dashpad::input {

namespace {

constexpr std::string_view no_value = "NOVALUE";
constexpr std::size_t most_labels = 10'000;

/// Takes the labels off; false once `line` is none.
bool take_label(std::string_view line, std::size_t number, MmeLabels& labels) {
  const auto colon = line.find(':');
  if (colon == std::string_view::npos || labels.all().size() == most_labels) return false;
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
               fmt::format("is not the number of samples in the file, {}", channel.values.size()));
}

}  // namespace

const MmeLabel* MmeLabels::find(std::string_view name) const {
  const std::string wanted = lower_case(name);
  const auto found =
      std::ranges::find_if(labels_, [&](const MmeLabel& label) { return lower_case(label.name) == wanted; });
  return found == labels_.end() ? nullptr : &*found;
}

std::string MmeLabels::value(std::string_view name) const {
  const MmeLabel* label = find(name);
  return label == nullptr ? "" : label->value;
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
    if (channel.values.size() == most_samples)
      faults.refuse(lines.number(), "", "", fmt::format("more than {} samples", most_samples));
    const ReadNumber number = read_number(line);
    if (number.kind != NumberKind::number)
      faults.add(lines.number(), "sample", line,
                 rule_for(line == no_value ? NumberKind::empty : number.kind));
    channel.values.push_back(number.value);
  }
  check_number_of_samples(channel, faults);
  return channel;
}

}  // namespace dashpad::input
