// The CSV of a history made by hand.

#include <limits>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dashpad/output/impact.hpp"

namespace dashpad {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

History one_row() {
  return {.time = {0.001},
          .force = {4.4482216152605},
          .acceleration = {-2 * standard_gravity},
          .velocity = {0.44704},
          .motion = {0.0254},
          .penetration = {0.0127},
          .support_deflection = {0.0127},
          .contact_radius = {1.0 / 3},
          .axis_strain = {0.5}};
}

TEST(HistoryCsv, HoldsPlainSiForPeopleWhoSeeSi) {
  EXPECT_EQ(output::history_csv(one_row(), units_of_files(unit_system("si"))),
            "time_s,force_N,acceleration_g,velocity_m_per_s,motion_m,penetration_m,support_deflection_m,"
            "contact_radius_m,axis_strain\n"
            "0.001,4.4482216152605,-2,0.44704,0.0254,0.0127,0.0127,0.3333333333333333,0.5\n");
}

TEST(HistoryCsv, NamesTheUnitsOfOtherSystems) {
  const std::string us = output::history_csv(one_row(), units_of_files(unit_system("us")));
  EXPECT_THAT(us, StartsWith("time_ms,force_lbf,acceleration_g,velocity_mph,motion_in,penetration_in,"));
  EXPECT_THAT(us, HasSubstr("\n1,"));
  EXPECT_THAT(output::history_csv(one_row(), units_of_files(unit_system("engineering-metric"))),
              StartsWith("time_ms,force_kN,acceleration_g,velocity_km_per_h,motion_mm,"));
}

TEST(HistoryCsv, HasTheColumnsOfSupportsSheetsAndLayers) {
  History history = one_row();
  history.transmitted_force = {11};
  history.body_motion = {0.012};
  history.pad_force = {13};
  history.layer_strain = {{0.14}, {0.15}};
  const std::string text = output::history_csv(history, plain_si());
  EXPECT_THAT(text, HasSubstr(",axis_strain,pad_force_N,transmitted_force_N,body_motion_m,"));
  EXPECT_THAT(text, HasSubstr("_layer_1,axis_strain_layer_2\n"));
  EXPECT_THAT(text, HasSubstr(",0.5,13,11,0.012,0.14,0.15\n"));
}

TEST(HistoryCsv, LeavesOutWhatIsNotFinite) {
  History history = one_row();
  history.force = {std::numeric_limits<double>::quiet_NaN()};
  EXPECT_THAT(output::history_csv(history, plain_si()), HasSubstr("\n0.001,,-2,"));
}

TEST(HistoryCsv, OfAnEmptyHistoryIsItsHeader) {
  const std::string text = output::history_csv({}, plain_si());
  EXPECT_EQ(text.find('\n'), text.size() - 1);
}

TEST(HistoryCsv, RefusesColumnsOfDifferentLength) {
  History history = one_row();
  history.velocity.clear();
  EXPECT_THROW(output::history_csv(history, plain_si()), std::invalid_argument);
}

}  // namespace
}  // namespace dashpad
