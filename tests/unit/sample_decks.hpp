#pragma once
/// Small decks with a foam, and what is read from them.

#include <filesystem>
#include <initializer_list>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dashpad/input/material_deck.hpp"
#include "shared/temporary_folder.hpp"

namespace dashpad::test {

/// A line of fields of 20 columns.
inline std::string fields_of_20(std::initializer_list<const char*> fields) {
  std::string line;
  for (const char* const field : fields) line += fmt::format("{:>20}", field);
  return line + "\n";
}

/// *MAT_057 number 1 with curve 31: 60 kg/m3 in t-mm-s, unloading 0.1 and 5.
inline const std::string foam_57 = "*MAT_057\n1,6e-11,4,31,,0.1\n5\n";
/// That curve: 0.02, 0.03 and 0.11 MPa in t-mm-s.
inline const std::string rows_31 = "0,0\n0.1,0.02\n0.4,0.03\n0.7,0.11\n";
inline const std::string curve_31 = "*DEFINE_CURVE\n31\n" + rows_31;

/// /MAT/LAW33 with function 8; `ids` are its numbers, such as 7/2 with a unit of its own.
inline std::string foam_33(const std::string& ids = "7", const char* density = "9E-11") {
  return "/MAT/LAW33/" + ids + "\nFoam\n" + fields_of_20({density}) +
         "                  20         0         8                   0\n\n" + fields_of_20({"0"});
}
/// That function: 0.2, 0.3 and 0.5 MPa in t-mm-s.
inline const std::string function_8 = "/FUNCT/8\nyield\n" + fields_of_20({"-0.7", "0.5"}) +
                                      fields_of_20({"-0.5", "0.3"}) + fields_of_20({"-0.1", "0.2"}) +
                                      fields_of_20({"0", "0"});

/// Reads decks in a folder of their own.
class DeckTest : public testing::Test {
 protected:
  using Foams = std::vector<input::DeckMaterial>;

  /// The deck with this text; without `units` in those that it states.
  [[nodiscard]] input::Reading<Foams> reading(const std::string& text, const std::string& units = "t-mm-s",
                                              input::Includes includes = input::Includes::ignored) const {
    const auto system = units.empty() ? std::nullopt : std::optional(input::deck_system(units));
    return input::read_material_deck(folder_.write("deck.k", text), system, includes);
  }
  [[nodiscard]] input::DeckMaterial only(const std::string& text, const std::string& units = "t-mm-s") const {
    return reading(text, units).value().at(0);
  }
  /// The same with the files that it includes.
  [[nodiscard]] Foams whole(const std::string& text) const {
    return reading(text, "t-mm-s", input::Includes::allowed).value();
  }
  /// "LINE: key = value: rule" of each fault, with the name of an included file before it.
  [[nodiscard]] std::vector<std::string> faults(const std::string& text, const std::string& units = "t-mm-s",
                                                input::Includes includes = input::Includes::ignored) const {
    std::vector<std::string> lines;
    for (input::Fault fault : reading(text, units, includes).faults()) {
      const auto name = std::filesystem::path(fault.file).lexically_relative(folder_.path()).generic_string();
      fault.file = name == "deck.k" ? "" : name;
      const std::string line = to_string(fault);
      lines.push_back(line.starts_with(':') ? line.substr(1) : line);
    }
    return lines;
  }
  [[nodiscard]] std::vector<std::string> faults_of_whole(const std::string& text) const {
    return faults(text, "t-mm-s", input::Includes::allowed);
  }

  TemporaryFolder folder_;
};

/// The stresses of the base curve, Pa.
inline std::vector<double> stresses_of(const input::DeckMaterial& found) {
  return std::visit(
      []<class Law>(const Law& law) -> std::vector<double> {
        if constexpr (requires { law.curves.base; })
          return std::get<TableCurve>(law.curves.base).stress;
        else
          return {};
      },
      found.material.law);
}

}  // namespace dashpad::test
