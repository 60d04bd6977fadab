// The printed report of the 1984 program against the second printout of the report's Appendix C: Ensolite
// AAC, the 21-parameter law, 20 mph. Columns are those of the FORMAT statements; digits that the scan shows
// misread are those that the neighbouring columns force.

#include <cmath>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dashpad/spit1984/run.hpp"

namespace dashpad::spit1984 {
namespace {

using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

constexpr const char* first_page = R"(SPHERE/PAD IMPACT TRACKER


SPHERE PARMS:

RADIUS=             0.300E+01 INCHES
WEIGHT=             0.100E+02 LBS

INITIAL SPEED=      0.200E+02 MPH
REBOUND SPEED=     -0.188E+02 MPH

PAD MATL TYPE=              5
THICKNESS=          0.100E+01 INCHES
PROPERTIES=
      0.796E+01      0.675E+00      0.109E+01      0.130E+00      0.156E+00      0.308E+01      0.415E+01      0.190E+00
      0.317E+01      0.580E+00      0.257E+01      0.296E+00      0.223E+01      0.164E-02      0.976E-05      0.987E-01
      0.660E+02      0.101E+02      0.279E+00      0.194E+01      0.290E-01

SUPPORT TYPE=               1
X=       0.000E+00      0.000E+00      0.000E+00      0.000E+00
F=       0.000E+00      0.000E+00      0.000E+00      0.000E+00
K=       0.600E+03      0.000E+00      0.000E+00      0.000E+00

INITIAL DELTA-T=    0.100E+00 MS
IMPACT DURATION=    0.243E+02 MS
TIME TO PEAK FORCE= 0.129E+02 MS
PEAK FORCE=        -0.128E+04 LB
)";

constexpr const char* heading =
    "\fRUN SUMMARY\n"
    "\n"
    "      TIME (MS)     FORCE (LB)      ACCEL (G)    SPEED (IPS)    MOTION (IN)    PENETR (IN)\n"
    "\n";

constexpr const char* table =
    R"(      0.000E+00      0.000E+00      0.000E+00      0.353E+03      0.000E+00      0.000E+00
      0.100E+01     -0.866E+02     -0.866E+01      0.352E+03      0.352E+00      0.208E+00
      0.200E+01     -0.174E+03     -0.174E+02      0.346E+03      0.701E+00      0.410E+00
      0.300E+01     -0.278E+03     -0.278E+02      0.338E+03      0.104E+01      0.576E+00
      0.400E+01     -0.397E+03     -0.397E+02      0.325E+03      0.137E+01      0.719E+00
      0.500E+01     -0.524E+03     -0.524E+02      0.308E+03      0.169E+01      0.814E+00
      0.600E+01     -0.664E+03     -0.664E+02      0.285E+03      0.199E+01      0.885E+00
      0.700E+01     -0.798E+03     -0.798E+02      0.257E+03      0.226E+01      0.931E+00
      0.800E+01     -0.914E+03     -0.914E+02      0.224E+03      0.250E+01      0.958E+00
      0.900E+01     -0.103E+04     -0.103E+03      0.186E+03      0.270E+01      0.976E+00
      0.100E+02     -0.114E+04     -0.114E+03      0.145E+03      0.286E+01      0.986E+00
      0.110E+02     -0.119E+04     -0.119E+03      0.998E+02      0.298E+01      0.989E+00
      0.120E+02     -0.123E+04     -0.123E+03      0.526E+02      0.306E+01      0.992E+00
      0.130E+02     -0.125E+04     -0.125E+03      0.435E+01      0.308E+01      0.993E+00
      0.140E+02     -0.123E+04     -0.123E+03     -0.441E+02      0.306E+01      0.993E+00
      0.150E+02     -0.118E+04     -0.118E+03     -0.915E+02      0.299E+01      0.992E+00
      0.160E+02     -0.114E+04     -0.114E+03     -0.137E+03      0.287E+01      0.991E+00
      0.170E+02     -0.103E+04     -0.103E+03     -0.179E+03      0.271E+01      0.987E+00
      0.180E+02     -0.909E+03     -0.909E+02     -0.217E+03      0.251E+01      0.980E+00
      0.190E+02     -0.775E+03     -0.775E+02     -0.250E+03      0.228E+01      0.967E+00
      0.200E+02     -0.638E+03     -0.638E+02     -0.277E+03      0.201E+01      0.944E+00
      0.210E+02     -0.483E+03     -0.483E+02     -0.299E+03      0.172E+01      0.907E+00
      0.220E+02     -0.337E+03     -0.337E+02     -0.316E+03      0.141E+01      0.857E+00
      0.230E+02     -0.187E+03     -0.187E+02     -0.326E+03      0.109E+01      0.785E+00
      0.234E+02     -0.128E+03     -0.128E+02     -0.328E+03      0.962E+00      0.748E+00
      0.235E+02     -0.115E+03     -0.115E+02     -0.329E+03      0.929E+00      0.738E+00
      0.236E+02     -0.101E+03     -0.101E+02     -0.329E+03      0.896E+00      0.729E+00
      0.237E+02     -0.875E+02     -0.875E+01     -0.330E+03      0.863E+00      0.718E+00
      0.238E+02     -0.724E+02     -0.724E+01     -0.330E+03      0.830E+00      0.709E+00
      0.239E+02     -0.595E+02     -0.595E+01     -0.330E+03      0.797E+00      0.699E+00
      0.240E+02     -0.463E+02     -0.463E+01     -0.331E+03      0.764E+00      0.688E+00
      0.241E+02     -0.334E+02     -0.334E+01     -0.331E+03      0.731E+00      0.675E+00
      0.242E+02     -0.217E+02     -0.217E+01     -0.331E+03      0.698E+00      0.662E+00
      0.243E+02     -0.999E+01      0.000E+00     -0.331E+03      0.665E+00      0.648E+00
)";

constexpr double time_step_ms = 0.1;

Deck published_deck() {
  Deck deck;
  deck.radius_in = 3;
  deck.speed_mph = 20;
  deck.weight_lb = 10;
  deck.pad = PadKey::twenty_one_parameter;
  deck.pad_parameters = {7.96,  0.675, 1.09,    0.13,    0.156,  3.08, 4.153, 0.19,  3.17, 0.58, 2.57,
                         0.296, 2.23,  1.64e-3, 9.76e-6, 0.0987, 66.0, 10.12, 0.279, 1.94, 0.029};
  deck.thickness_in = 1;
  deck.support = 1;
  deck.support_parameters[8] = 600;
  deck.time_step_ms = time_step_ms;
  deck.print_interval = 10;
  return deck;
}

/// The steps that Appendix C prints; all others are NaN, so that one printed by mistake is seen.
std::vector<Step> published_history() {
  const double absent = std::numeric_limits<double>::quiet_NaN();
  std::vector<Step> history(244, {absent, absent, absent, absent, absent, absent});
  std::istringstream rows{table};
  Step step;
  while (rows >> step.time_ms >> step.force_lb >> step.acceleration_g >> step.speed_in_per_s >>
         step.motion_in >> step.penetration_in)
    history.at(static_cast<std::size_t>(std::lround(step.time_ms / time_step_ms))) = step;
  return history;
}

Run published_run() {
  Run run;
  run.history = published_history();
  run.rebound_speed_mph = -18.8;
  run.duration_ms = 24.3;
  run.time_of_peak_force_ms = 12.9;
  run.peak_force_lb = -1280;
  run.tangent_stiffness_lb_per_in = {600, 0, 0, 0};
  return run;
}

/// A run of so many steps, from first contact on; the number of the step is its force.
Run run_of(int steps) {
  Run run;
  for (int step = 0; step < steps; ++step) run.history.push_back({0, static_cast<double>(step), 0, 0, 0, 0});
  return run;
}

/// The steps printed of run_of().
std::vector<int> steps_printed(int steps, int interval) {
  Deck deck;
  deck.print_interval = interval;
  const std::string text = listing(deck, run_of(steps), Device::printer);
  std::istringstream lines{text.substr(text.find("PENETR (IN)\n\n") + 13)};
  std::vector<int> printed;
  double time = 0;
  double force = 0;
  for (std::string line; std::getline(lines, line);) {
    std::istringstream{line} >> time >> force;
    printed.push_back(static_cast<int>(force));
  }
  return printed;
}

std::string with_abend(Abend abend, Device device) {
  auto run = published_run();
  run.abend = abend;
  run.speed_error = 0.01234;
  return listing(published_deck(), run, device);
}

TEST(Listing1984, IsAppendixCCharacterByCharacter) {
  const std::string text = listing(published_deck(), published_run(), Device::printer);
  EXPECT_EQ(text, std::string(first_page) + heading + table);
  EXPECT_EQ(listing(published_deck(), published_run(), Device::terminal), text);
}

TEST(Listing1984, FitsThePaper) {
  auto run = published_run();
  run.precision_stops = {{99999, -1e99, -1e99}};
  run.abend = Abend::rate_sensitive_instability;
  std::istringstream lines{listing(published_deck(), run, Device::terminal)};
  constexpr std::size_t widest = 131;  // 132 with the carriage control
  for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), widest) << line;
}

TEST(Listing1984, PutsSupportPointsAndStiffnessesBelowEachOther) {
  Deck deck = published_deck();
  deck.support = 4;
  deck.support_parameters = {0.1, 900, 0.2, 2000, 0.3, 4000, 0.4, 9000, 1, 2, 3, 4};
  auto run = published_run();
  run.tangent_stiffness_lb_per_in = {9000, 11000, 20000, 50000};
  EXPECT_THAT(listing(deck, run, Device::printer),
              HasSubstr("SUPPORT TYPE=               4\n"
                        "X=       0.100E+00      0.200E+00      0.300E+00      0.400E+00\n"
                        "F=       0.900E+03      0.200E+04      0.400E+04      0.900E+04\n"
                        "K=       0.900E+04      0.110E+05      0.200E+05      0.500E+05\n"));
}

TEST(Listing1984, TellsBothDevicesOfThreeAbends) {
  for (const Device device : {Device::printer, Device::terminal}) {
    EXPECT_THAT(with_abend(Abend::too_many_iterations, device),
                StartsWith("SPHERE/PAD IMPACT TRACKER\n\n\nABEND - TOO MANY ITERATIONS\n\nSPHERE PARMS:\n"));
    EXPECT_THAT(with_abend(Abend::bisection_failed, device),
                StartsWith("SPHERE/PAD IMPACT TRACKER\n\n\nABEND - BISECTION FAILED\n\nSPHERE PARMS:\n"));
    EXPECT_THAT(with_abend(Abend::too_many_time_steps, device),
                StartsWith("SPHERE/PAD IMPACT TRACKER\n\n\nABEND - TOO MANY TIME STEPS\n\nSPHERE PARMS:\n"));
  }
}

TEST(Listing1984, TellsOnlyTheTerminalOfTheOtherTwo) {
  EXPECT_THAT(
      with_abend(Abend::rate_sensitive_instability, Device::terminal),
      HasSubstr("\n\nABEND - RATE-SENSITIVE INSTABILITY - SPEED ERROR= 0.123E-01\n\nSPHERE PARMS:\n"));
  EXPECT_THAT(with_abend(Abend::too_many_contact_divisions, Device::terminal),
              HasSubstr("\n\nABEND - TOO MANY CONTACT DIVISIONS\n\nSPHERE PARMS:\n"));
  const std::string untroubled = std::string(first_page) + heading + table;
  EXPECT_EQ(with_abend(Abend::rate_sensitive_instability, Device::printer), untroubled);
  EXPECT_EQ(with_abend(Abend::too_many_contact_divisions, Device::printer), untroubled);
}

TEST(Listing1984, PrintsEverythingAfterAnyAbend) {
  for (const Abend abend : {Abend::too_many_iterations, Abend::bisection_failed, Abend::too_many_time_steps,
                            Abend::rate_sensitive_instability, Abend::too_many_contact_divisions})
    for (const Device device : {Device::printer, Device::terminal})
      EXPECT_THAT(with_abend(abend, device), EndsWith(std::string(heading) + table));
}

TEST(Listing1984, TellsTheTerminalOfPrecisionStopsBeforeTheAbend) {
  auto run = published_run();
  run.precision_stops = {{7, -90.8, 0.0312}, {123, -1280, -0.5}};
  run.abend = Abend::too_many_iterations;
  EXPECT_THAT(listing(published_deck(), run, Device::terminal),
              StartsWith("SPHERE/PAD IMPACT TRACKER\n"
                         "\n"
                         "\n"
                         "STEP    7 FORCE=-0.908E+02 ERROR= 0.312E-01\n"
                         "\n"
                         "STEP  123 FORCE=-0.128E+04 ERROR=-0.500E+00\n"
                         "\n"
                         "ABEND - TOO MANY ITERATIONS\n"));
  EXPECT_THAT(listing(published_deck(), run, Device::printer), Not(HasSubstr("STEP ")));
}

TEST(Listing1984, PrintsEveryStepOfTheLastInterval) {
  EXPECT_EQ(steps_printed(13, 5), (std::vector<int>{0, 5, 8, 9, 10, 11, 12}));
  EXPECT_EQ(steps_printed(11, 5), (std::vector<int>{0, 5, 6, 7, 8, 9, 10}));
  EXPECT_EQ(steps_printed(6, 5), (std::vector<int>{0, 1, 2, 3, 4, 5}));
  EXPECT_EQ(steps_printed(4, 1), (std::vector<int>{0, 1, 2, 3}));
}

TEST(Listing1984, BeginsAShortRunAtFirstContact) {
  EXPECT_EQ(steps_printed(5, 5), (std::vector<int>{0, 1, 2, 3, 4}));
  EXPECT_EQ(steps_printed(3, 10), (std::vector<int>{0, 1, 2}));
  EXPECT_EQ(steps_printed(2, std::numeric_limits<int>::max()), (std::vector<int>{0, 1}));
  EXPECT_EQ(steps_printed(0, 10), std::vector<int>{});
}

TEST(Listing1984, PrintsEveryStepWhereTheIntervalIsNotPositive) {
  EXPECT_EQ(steps_printed(3, 0), (std::vector<int>{0, 1, 2}));
  EXPECT_EQ(steps_printed(3, std::numeric_limits<int>::min()), (std::vector<int>{0, 1, 2}));
}

}  // namespace
}  // namespace dashpad::spit1984
