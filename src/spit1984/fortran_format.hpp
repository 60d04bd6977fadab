#pragma once
/// The parts of Fortran's FORMAT that the 1984 program uses, as run by the DECSystem-10's FOROTS.

#include <optional>
#include <string>
#include <string_view>

namespace dashpad::spit1984 {

/// Ew.d, with at least one decimal: "0.353E+03", right-aligned. Exact ties round away from zero. From 1E+100
/// on the exponent has three digits and no E: "0.100+100". In a field that is too narrow the zero before the
/// point is dropped; if that is not enough, the field is all asterisks. Infinities and NaN, which the machine
/// did not have, are words.
std::string edit_e(double value, int width, int decimals);

/// Iw, right-aligned, or asterisks.
std::string edit_i(int value, int width);

/// The output of WRITE statements to a printing device. Each descriptor of a FORMAT is a call:
/// FORMAT(8H0RADIUS=,12X,E10.3/) is text("0RADIUS=").skip(12).e(radius, 10, 3).end_record().end_record().
class PrintedRecords {
 public:
  PrintedRecords& text(std::string_view text);  ///< nH... or '...'
  PrintedRecords& skip(int columns);            ///< nX
  /// Ew.d, and Iw.
  PrintedRecords& e(double value, int width, int decimals) { return text(edit_e(value, width, decimals)); }
  PrintedRecords& i(int value, int width) { return text(edit_i(value, width)); }

  /// A slash, or the end of the FORMAT. The first character of the record is carriage control: '1' begins a
  /// new page (a form feed, except on the very first line), '0' leaves a line empty, any other just begins a
  /// line. An empty record is an empty line. Nothing else is trimmed.
  PrintedRecords& end_record();

  /// A dollar sign at the end of the FORMAT: ends the record, but the cursor stays on the line.
  PrintedRecords& end_record_on_the_line();

  /// The text up to the last end of a record.
  [[nodiscard]] const std::string& printed() const { return printed_; }

 private:
  std::string record_;
  std::string printed_;
};

/// The fields of one typed line, from left to right. A field is absent if it is not a number or out of range;
/// beyond the end of the line fields are blank, hence zero.
///
/// The rules are those of the FORTRAN-10 manual as far as we know them. Two are our choice: blanks inside a
/// field of given width are ignored (as in FORTRAN-77; in FORTRAN-66 they were zeros, and "20 " was 200), and
/// a comma does not end such a field.
class TypedRecord {
 public:
  explicit TypedRecord(std::string_view line) : rest_(line) {}

  std::optional<int> i();              ///< I without width: up to a blank or a comma
  std::optional<double> e(int width);  ///< Ew.0: the next `width` characters: 20, .1, 1.5E1, 1.5D1, 1.5+1
  std::optional<double> f();           ///< F without width: up to a blank or a comma; numbers as in e()

 private:
  std::string_view free_field();

  std::string_view rest_;
};

}  // namespace dashpad::spit1984
