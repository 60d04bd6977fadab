#pragma once
/// Large files of numbers as measuring programs write them: read with limits, as lines of UTF-8.

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "dashpad/input/fault.hpp"

namespace dashpad::input {

inline constexpr std::size_t largest_measurement = std::size_t{1} << 30;  // bytes
inline constexpr std::size_t max_samples = 50'000'000;
inline constexpr std::size_t max_measurement_faults = 200;

/// The faults of one file; stops the reading, by an exception, when there are too many.
class MeasurementFaults {
 public:
  explicit MeasurementFaults(std::string file) : file_(std::move(file)) {}

  /// The text that the lines are of, for excerpts. It must outlive what is thrown here.
  void are_in(std::string_view text) { text_ = text; }
  /// Long values are cut. Throws InputError once there are most_measurement_faults.
  void add(std::size_t line, std::string key, std::string_view value, std::string rule);
  void throw_if_any() const;
  [[nodiscard]] bool none() const { return faults_.empty(); }
  /// Adds this one fault and throws.
  [[noreturn]] void refuse(std::size_t line, std::string key, std::string_view value, std::string rule);

 private:
  [[noreturn]] void throw_all() const;

  std::string file_;
  std::string_view text_;
  std::vector<Fault> faults_;
};

/// The bytes of an open file to its end, but at most `most`. `expected` is a guess of their number; some
/// files grow while they are read, or tell nothing. `name` is for messages. Throws InputError.
std::string read_bytes(int descriptor, const std::string& name, std::size_t most, std::size_t expected = 0);

/// All bytes of an open regular file, at most `most`; closes `descriptor`. `name` is for messages. Throws
/// InputError, also for a file that has more unless `cut`.
std::string read_descriptor(int descriptor, const std::string& name, std::size_t most, bool cut = false);

/// All bytes of a regular file of at most `most`, or of a stream that was given. Throws InputError.
std::string read_measurement(const std::filesystem::path& file, std::size_t most = largest_measurement);

/// The bytes of a file as text, without a byte order mark. Refuses what is UTF-16 or no text at all.
std::string_view text_in(std::string_view content, MeasurementFaults& faults);

/// Takes lines off a text, one after the other, whatever they end in: LF, CR LF or CR.
class LineReader {
 public:
  explicit LineReader(std::string_view text) : rest_(text) {}
  /// False at the end. A line end at the very end of the text begins no further line.
  bool next(std::string_view& line);
  [[nodiscard]] std::size_t number() const { return number_; }  ///< of the latest line, from 1
  /// How many kinds of line ends were met.
  [[nodiscard]] int kinds_of_ends() const { return int{lf_} + int{cr_lf_} + int{cr_}; }

 private:
  std::string_view rest_;
  const char* line_feed_ = nullptr;  ///< the next one, or the end of the text
  std::size_t number_ = 0;
  bool lf_ = false, cr_lf_ = false, cr_ = false;
};

std::string_view without_blanks(std::string_view text);
bool is_utf8(std::string_view text);
/// Text that is not UTF-8 is taken for Latin-1.
std::string to_utf8(std::string_view text);
/// a to z for A to Z, and the other way round.
std::string lower_case(std::string_view text);
std::string upper_case(std::string_view text);

enum class NumberKind { number, not_finite, out_of_range, text, empty };
struct ReadNumber {
  NumberKind kind = NumberKind::empty;
  double value = 0;
};
/// The whole of `text`, without blanks around it, as a number. `decimal` is '.' or ','.
ReadNumber read_number(std::string_view text, char decimal = '.');
/// The rule for a field that holds no number.
std::string rule_for(NumberKind kind);

}  // namespace dashpad::input
