#pragma once
/// The text of ISO-MME files: lines "label :value", then, in channel files, a sample a line.

#include <string>
#include <string_view>
#include <vector>

#include "input/measurement/measurement_text.hpp"

namespace dashpad::input {

struct MmeLabel {
  std::string name;
  std::string value;  ///< UTF-8; empty for NOVALUE
  std::size_t line = 0;
};

class MmeLabels {
 public:
  void add(MmeLabel label) { labels_.push_back(std::move(label)); }
  /// The first of that name, in small or capital letters; null if there is none.
  [[nodiscard]] const MmeLabel* find(std::string_view name) const;
  /// Its value; "" if there is none.
  [[nodiscard]] std::string value(std::string_view name) const;
  [[nodiscard]] const std::vector<MmeLabel>& all() const { return labels_; }

 private:
  std::vector<MmeLabel> labels_;
};

/// The labels up to the first line that is none. In .mme and .chn files that is the end.
MmeLabels read_mme_labels(std::string_view text);

struct MmeChannelText {
  MmeLabels labels;
  std::vector<double> values;
};

/// A whole channel file. Its number of samples must be the one that it claims.
MmeChannelText read_mme_channel(std::string_view text, MeasurementFaults& faults);

}  // namespace dashpad::input
