#pragma once
/// Large text files from measuring programs: reading with limits, lines, UTF-8, numbers.

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

/// The faults of one file. Throws when there are too many.
class MeasurementFaults {
 public:
  explicit MeasurementFaults(std::string file) : file_(std::move(file)) {}

  /// Sets the text that the lines belong to, for excerpts. It must outlive the exceptions.
  void are_in(std::string_view text) { text_ = text; }
  /// Adds a fault, with long values cut. Throws InputError at max_measurement_faults.
  void add(std::size_t line, std::string key, std::string_view value, std::string rule);
  void throw_if_any() const {
    if (!faults_.empty()) throw_all();
  }
  [[nodiscard]] bool none() const { return faults_.empty(); }
  [[nodiscard]] std::size_t count() const { return faults_.size(); }
  /// Takes back the faults from number `first`, from 0, on.
  std::vector<Fault> split_off(std::size_t first);
  void add(std::vector<Fault> faults);
  /// Adds a fault and throws.
  [[noreturn]] void refuse(std::size_t line, std::string key, std::string_view value, std::string rule);

 private:
  [[noreturn]] void throw_all() const;

  std::string file_;
  std::string_view text_;
  std::vector<Fault> faults_;
};

/// The bytes of an open file, at most `most`. `expected` is a guess of their number; some files grow while
/// they are read, or have no size. `name` is for messages. Throws InputError.
std::string read_bytes(int descriptor, const std::string& name, std::size_t most, std::size_t expected = 0);

/// The bytes of an open regular file, at most `most`; closes `descriptor`. Throws InputError, also if the
/// file has more, unless `cut`.
std::string read_descriptor(int descriptor, const std::string& name, std::size_t most, bool cut = false);

/// The bytes of a regular file or of a stream that was given, at most `most`. Throws InputError.
std::string read_measurement(const std::filesystem::path& file, std::size_t most = largest_measurement);

/// The text of a file without a byte order mark. Refuses UTF-16 and binary data.
std::string_view text_in(std::string_view content, MeasurementFaults& faults);

/// Splits a text into lines, which may end in LF, CR LF or CR.
class LineReader {
 public:
  explicit LineReader(std::string_view text) : rest_(text) {}
  /// False at the end. A line end at the very end begins no further line.
  bool next(std::string_view& line);
  [[nodiscard]] std::size_t number() const { return number_; }  ///< of the latest line, from 1
  /// The number of different line ends.
  [[nodiscard]] int kinds_of_ends() const { return int{lf_} + int{cr_lf_} + int{cr_}; }

 private:
  std::string_view rest_;
  const char* line_feed_ = nullptr;  ///< the next one, or the end of the text
  std::size_t number_ = 0;
  bool lf_ = false, cr_lf_ = false, cr_ = false;
};

std::string_view without_blanks(std::string_view text);
bool is_utf8(std::string_view text);
/// Text that is not UTF-8 is taken as Latin-1.
std::string to_utf8(std::string_view text);
std::string lower_case(std::string_view text);
std::string upper_case(std::string_view text);

enum class NumberKind { number, not_finite, out_of_range, text, empty };
struct ReadNumber {
  NumberKind kind = NumberKind::empty;
  double value = 0;
};
/// The whole text, trimmed, as a number. `decimal` is '.' or ','.
ReadNumber read_number(std::string_view text, char decimal = '.');
std::string rule_for(NumberKind kind);

}  // namespace dashpad::input
