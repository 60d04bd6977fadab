#pragma once
/// The cards of the foams of LS-DYNA and Radioss, field by field, for reading and writing.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "dashpad/quantities/unit_system.hpp"
#include "input/measurement/measurement_text.hpp"

namespace dashpad::input {

/// The content of a field: a pure number, a number with a unit, or a whole number.
enum class Content : std::uint8_t { number, stress, density, rate, time, whole };

struct DeckField {
  const char* name;
  Content content = Content::number;
  /// The meaning of a field without a counterpart here, reported if the field is set; "" if it is not.
  const char* lost = nullptr;
  std::size_t width = 10;  ///< columns; 20 in the long format of LS-DYNA

  [[nodiscard]] bool is_read() const { return lost == nullptr; }
  [[nodiscard]] bool matters() const { return is_read() || *lost != '\0'; }
};
/// The fields of a line, from its first column on.
using DeckCard = std::span<const DeckField>;

namespace deck {

using enum Content;

inline constexpr const char* unread = "";
inline constexpr const char* no_tension = "a pad carries no tension";
inline constexpr const char* no_damping = "the viscous damping of the element is left out";
inline constexpr const char* no_bulk_viscosity = "bulk viscosity is left out";
inline constexpr const char* no_contact_stiffness = "contact in Dashpad needs no stiffness";
inline constexpr const char* no_geometry = "the reference geometry is left out";
inline constexpr const char* no_widening = "the pad does not expand laterally";
inline constexpr const char* zero_is_taken = "the pad does not expand laterally; 0 is used";
inline constexpr const char* no_viscoelasticity = "the viscoelastic part is left out";
inline constexpr const char* no_averaging = "the rate is not averaged over time steps; see lag_strain";
inline constexpr const char* no_filter = "the rate is not filtered; see lag_strain";

// --- LS-DYNA ---
inline constexpr DeckField low_density_1[]{{"MID", whole},
                                           {"RO", density},
                                           {"E", stress},
                                           {"LCID", whole},
                                           {"TC", number, no_tension},
                                           {"HU"},
                                           {"BETA", number, "the hysteresis does not decay in Dashpad"},
                                           {"DAMP", number, no_damping}};
inline constexpr DeckField low_density_2[]{{"SHAPE"},
                                           {"FAIL", number, no_tension},
                                           {"BVFLAG", number, no_bulk_viscosity},
                                           {"ED", number, no_viscoelasticity},
                                           {"BETA1", number, no_viscoelasticity},
                                           {"KCON", number, no_contact_stiffness},
                                           {"REF", number, no_geometry}};
inline constexpr DeckField fu_chang_1[]{{"MID", whole},
                                        {"RO", density},
                                        {"E", stress},
                                        {"KCON", number, no_contact_stiffness},
                                        {"TC", number, no_tension},
                                        {"FAIL", number, no_tension},
                                        {"DAMP", number, no_damping},
                                        {"TBID", whole}};
inline constexpr DeckField fu_chang_2[]{{"BVFLAG", number, no_bulk_viscosity},
                                        {"SFLAG"},
                                        {"RFLAG", number, "Dashpad uses the rate of compression"},
                                        {"TFLAG", number, no_tension},
                                        {"PVID", whole, "the pressure curve is left out"},
                                        {"SRAF", number, no_averaging},
                                        {"REF", number, no_geometry},
                                        {"HU"}};
inline constexpr DeckField fu_chang_3[]{
    {"D0", number, unread}, {"N0", number, unread}, {"N1", number, unread}, {"N2", number, unread},
    {"N3", number, unread}, {"C0", number, unread}, {"C1", number, unread}, {"C2", number, unread}};
inline constexpr DeckField fu_chang_4[]{
    {"C3", number, unread},  {"C4", number, unread},   {"C5", number, unread},   {"AIJ", number, unread},
    {"SIJ", number, unread}, {"MINR", number, unread}, {"MAXR", number, unread}, {"SHAPE"}};
inline constexpr DeckField fu_chang_5[]{{"EXPON"}, {"RIULD", number, "in Dashpad, recoil governs unloading"}};
inline constexpr DeckField crushable_1[]{{"MID", whole},
                                         {"RO", density},
                                         {"E", stress},
                                         {"PR", number, no_widening},
                                         {"LCID", whole},
                                         {"TSC", number, no_tension},
                                         {"DAMP", number, no_damping},
                                         {"MODEL", whole}};
inline constexpr DeckField modified_crushable_1[]{{"MID", whole},
                                                  {"RO", density},
                                                  {"E", stress},
                                                  {"PR", number, no_widening},
                                                  {"TID", whole},
                                                  {"TSC", number, no_tension},
                                                  {"DAMP", number, no_damping},
                                                  {"NCYCLE", number, no_averaging}};
inline constexpr DeckField modified_crushable_2[]{
    {"SRCLMT", number, "the change in rate is not limited; see lag_strain"}, {"SFLAG", whole}};

inline constexpr DeckCard low_density[]{low_density_1, low_density_2};
inline constexpr DeckCard fu_chang[]{fu_chang_1, fu_chang_2, fu_chang_3, fu_chang_4, fu_chang_5};
inline constexpr DeckCard crushable[]{crushable_1};
inline constexpr DeckCard modified_crushable[]{modified_crushable_1, modified_crushable_2};

// --- Radioss ---
inline constexpr DeckField density_line[]{{"RHO_I", density, nullptr, 20}};
/// A function with its rate and scale. The first field has other names in some laws.
inline constexpr DeckField function_row[]{
    {"fct_ID", whole}, {"Eps_dot", rate, nullptr, 20}, {"Fscale", number, nullptr, 20}};
inline constexpr DeckField law_33_elastic[]{{"E", stress, nullptr, 20},
                                            {"Ka", whole, "the viscous part of the skeleton is left out"},
                                            {"fct_IDf", whole},
                                            {"Fscale", number, nullptr, 20}};
inline constexpr DeckField law_33_gas[]{
    {"P0", stress, nullptr, 20}, {"Phi", number, nullptr, 20}, {"Gamma_0", number, nullptr, 20}};
inline constexpr DeckField law_33_yield[]{{"A", stress, nullptr, 20},
                                          {"B", stress, nullptr, 20},
                                          {"C", number, nullptr, 20},
                                          {"SIG_COFF", number, no_tension, 20}};
inline constexpr DeckField law_62_flags[]{{"Nu", number, zero_is_taken, 20},
                                          {"N", whole},
                                          {"M", whole},
                                          {"mu_max", number, "the viscosity is not limited", 20},
                                          {"Flag_Visc", whole},
                                          {"Flag_Rigi", whole}};
inline constexpr DeckField law_70_elastic[]{
    {"E0", stress, nullptr, 20},
    {"nu", number, no_widening, 20},
    {"E_max", stress, "the stress follows the curves directly, without a modulus", 20},
    {"EPS_max", number, unread, 20},
    {"Itens", whole, no_tension}};
inline constexpr DeckField law_70_flags[]{{"Fcut", number, no_filter, 20},
                                          {"Fsmooth", whole, unread},
                                          {"NL", whole},
                                          {"NuL", whole},
                                          {"Iflag", whole},
                                          {"Shape", number, nullptr, 20},
                                          {"Hys", number, nullptr, 20}};
inline constexpr DeckField law_90_elastic[]{{"E0", stress, nullptr, 20}, {"nu", number, no_widening, 20}};
inline constexpr DeckField law_90_flags[]{{"NL", whole},
                                          {"Ismooth", whole, no_filter},
                                          {"Fcut", number, unread, 20},
                                          {"Shape", number, nullptr, 20},
                                          {"Hys", number, nullptr, 20},
                                          {"Alpha", number, nullptr, 20}};

}  // namespace deck

/// A foam of LS-DYNA: its keyword in words and as a number, its cards, and their least number.
struct LsDynaFoam {
  std::string_view words, number;
  bool crushable;
  std::span<const DeckCard> cards;
  std::size_t fewest;
};
inline constexpr LsDynaFoam ls_dyna_foams[]{
    {"LOW_DENSITY_FOAM", "057", false, deck::low_density, 2},
    {"CRUSHABLE_FOAM", "063", true, deck::crushable, 1},
    {"FU_CHANG_FOAM", "083", false, deck::fu_chang, 4},
    {"MODIFIED_CRUSHABLE_FOAM", "163", true, deck::modified_crushable, 2}};

// Numbers of decks. If one unit is a power of ten of the other, only the exponent is changed, so that a
// number is the same to the last bit after writing and reading.

struct DeckUnit {
  double factor = 1;                    ///< one unit in SI
  std::optional<int> power_of_ten = 0;  ///< of the factor, where it is one
};

/// Throws UnitError.
DeckUnit deck_unit(const std::string& unit, const std::string& si_unit);

struct DeckUnits {
  explicit DeckUnits(const UnitSystem& system);
  [[nodiscard]] const DeckUnit& of(Content content) const;

  DeckUnit none;
  DeckUnit stress;   ///< Pa
  DeckUnit density;  ///< kg/m3
  DeckUnit rate;     ///< 1/s
  DeckUnit time;     ///< s
};

/// The number in SI. Like in Fortran, 1.5E-3, 1.5D-3 and 1.5-3 are the same number.
ReadNumber read_deck_number(std::string_view text, const DeckUnit& unit);

/// The value in the unit of the deck, with as many digits as are needed to read the same number back, or as
/// fit into `width` columns.
std::string deck_number(double value, const DeckUnit& unit, std::size_t width);

}  // namespace dashpad::input
