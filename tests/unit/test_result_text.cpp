// The summary for people: every figure in the right unit, every warning in plain sight.

#include <cmath>
#include <limits>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dashpad/output/materials.hpp"
#include "dashpad/output/text/case.hpp"
#include "example_result.hpp"
#include "impact_text.hpp"
#include "quantities/text.hpp"
#include "shared/samples.hpp"

namespace dashpad {
namespace {

using output::Detail;
using testing::AllOf;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

/// In Markdown, where no line is broken.
std::string in_markdown(const Summary& summary, const char* units = "si") {
  const ImpactCase impact = test::example_case();
  Solution solution;
  solution.summary = summary;
  return output::to_markdown(output::impact_document({impact, {}, solution}, unit_system(units)));
}

std::string shown(const Summary& summary, const char* units = "si", Detail detail = Detail::all) {
  return test::impact_text(test::example_case(), summary, {}, unit_system(units), detail);
}

/// A half sine of 100 g in 10 ms, whose windows and clips are one each; with errors of a thousandth.
injury::InjuryFigures half_sine_figures() {
  Pulse pulse;
  for (int i = 0; i <= 100; ++i) {
    pulse.time.push_back(1e-4 * i);
    pulse.acceleration.push_back(-100 * standard_gravity * std::sin(std::acos(-1) * i / 100));
  }
  injury::InjuryFigures figures = injury::injury_figures(pulse);
  figures.errors = {1e-3, 1e-3, 1e-3, 1e-3, 1e-3, 1e-3, 1e-3, 1e-3, 1e-3};
  return figures;
}

std::string main_text(const Summary& summary, const injury::InjuryFigures& injury) {
  return test::impact_text(test::example_case(), summary, injury, unit_system("si"), Detail::main);
}

TEST(ResultText, SaysWhereAFoamWasGivenNoLoss) {
  ImpactCase impact = test::example_case();
  auto foam = test::sample_law<Foam>();
  const auto shown_of = [&](const Foam& law) {
    impact.pad.material.law = law;
    return test::impact_text(impact, test::example_summary(), {}, unit_system("si"), Detail::main);
  };
  EXPECT_THAT(shown_of(foam), Not(HasSubstr("no loss")));
  foam.friction = 0;
  foam.curves.rate_effect = NoRateEffect{};
  EXPECT_THAT(shown_of(foam), Not(HasSubstr("no loss")));
  foam.unloading_factor = 1;
  EXPECT_THAT(shown_of(foam), HasSubstr("restitution 0.9622; no loss is specified for the pad"));
  foam.unloading_curve = test::soft_table();
  EXPECT_THAT(shown_of(foam), Not(HasSubstr("no loss")));
}

TEST(Numbers, HaveFiveSignificantDigits) {
  EXPECT_EQ(significant(8.9408), "8.9408");
  EXPECT_EQ(significant(1.0), "1.0000");
  EXPECT_EQ(significant(9.999999), "10.000");
  EXPECT_EQ(significant(12345.4), "12345");
  EXPECT_EQ(significant(123456.7), "123457");
  EXPECT_EQ(significant(-0.0123456), "-0.012346");
  EXPECT_EQ(significant(0.0), "0");
  EXPECT_EQ(significant(std::numeric_limits<double>::infinity()), "none");
  EXPECT_EQ(brief(25.4), "25.4");
  EXPECT_EQ(brief(250000), "250000");
  EXPECT_EQ(percentage(3.14159e-5), "0.0031 %");
  EXPECT_EQ(percentage(std::numeric_limits<double>::quiet_NaN()), "unknown");
}

TEST(SummaryText, SaysFirstHowItEndedAndLastWhatStruckWhat) {
  const std::string head = "Peak 130 g\nHead on a dashboard\nThe impactor rebounded and left the pad.\n\n";
  EXPECT_THAT(
      shown(test::example_summary(), "si", Detail::main),
      AllOf(StartsWith(head + "  Peak "),
            HasSubstr("\n\nA sphere of mass 4.5 kg and radius 76.2 mm strikes, at 8.9408 m/s,\n"
                      "a pad of soft-foam (linear-viscoelastic law), 25.4 mm thick, on a support with a "
                      "stiffness of\n  105 N/mm.\n"
                      "Estimated numerical error")));
  EXPECT_THAT(shown(test::example_summary()), StartsWith(head + "The impact:\n  Peak "));
  EXPECT_THAT(in_markdown(test::example_summary()),
              AllOf(StartsWith("# Peak 130 g\n\nHead on a dashboard\n\nThe impactor"),
                    HasSubstr("| Impactor | a sphere of mass 4.5 kg and radius 76.2 mm, at 8.9408 m/s | "),
                    HasSubstr("| Pad | soft-foam (linear-viscoelastic law), 25.4 mm thick | "),
                    HasSubstr("| Support | a support with a stiffness of 105 N/mm | ")));
}

TEST(SummaryText, SaysEqualWindowsAndErrorsOnce) {
  EXPECT_THAT(
      main_text(test::example_summary(), half_sine_figures()),
      AllOf(ContainsRegex("  Peak acceleration +100.0 g +at 5 ms\n"),
            ContainsRegex(
                "  HIC15 +414\\.[67] +from [0-9.]+ to [0-9.]+ ms; the same for HIC36 and\\s+unlimited "
                "HIC\n  3 ms clip +89.10 g +from 3.5 to 6.5 ms; the same for\\s+the\\s+"
                "cumulative\\s+3 ms\\s+clip\n"),
            HasSubstr("Estimated numerical error at most 0.1 %, energy residual 0.005 %;"),
            Not(HasSubstr("±"))));
}

/// A row keeps its error where that is much larger than what is said of all.
TEST(SummaryText, FlagsALargeError) {
  injury::InjuryFigures figures = half_sine_figures();
  figures.errors.hic15 = 0.02;
  EXPECT_THAT(main_text(test::example_summary(), figures),
              AllOf(ContainsRegex("  HIC15 +414.* ± 2 % "), HasSubstr("at most 0.1 % except where ±")));
}

TEST(SummaryText, DifferentWindowsHaveARowEach) {
  injury::InjuryFigures figures = half_sine_figures();
  figures.hic36.value *= 1.01;
  figures.cumulative_3ms.level *= 1.01;
  EXPECT_THAT(main_text(test::example_summary(), figures),
              AllOf(ContainsRegex("HIC15 +414"), ContainsRegex("HIC36 +418"),
                    ContainsRegex("3 ms clip +89.10"), ContainsRegex("Cumulative 3 ms clip +89.99")));
}

TEST(SummaryText, Fits100Columns) {
  Summary summary = test::example_summary();
  summary.extrapolations = {
      {Beyond::strain, std::string(300, 'x') + " " + std::string(30, 'y')},
      {Beyond::rate,
       "word word word word word "
       "word word word word word word word word word word word word word word word word word word"}};
  summary.errors.peak_force = summary.errors.rebound_speed = 0.3;
  for (const UnitSystem& units : unit_systems())
    for (const Detail detail : {Detail::main, Detail::all}) {
      std::istringstream text(
          test::impact_text(test::example_case(), summary, half_sine_figures(), units, detail));
      for (std::string line; std::getline(text, line);)
        if (line.find('x') == std::string::npos || line.find("radius") != std::string::npos) {
          EXPECT_LE(width_of(line), 100U) << line;
        }
    }
}

TEST(SummaryText, HasEachControlledFigureWithItsError) {
  EXPECT_THAT(
      shown(test::example_summary()),
      AllOf(ContainsRegex("Peak force +5768.8 N +± 0.003 %"),
            ContainsRegex("Peak acceleration +130.00 g +± 0.003 %"),
            ContainsRegex("Time to peak force +13.023 ms +± 0.002 %"),
            ContainsRegex("Peak penetration +20.320 mm +± 0.0003 % +80.000 % of the pad"),
            ContainsRegex("Peak displacement +79.965 mm +± 0.0001 %"),
            ContainsRegex("Rebound speed +8.6031 m/s +± 0.001 % +restitution 0.96223"),
            ContainsRegex("End of contact +24.200 ms +± 0.004 % +force below 0.1 % of its peak"),
            ContainsRegex("Energy absorbed by the pad +7.4147 % +± 0.002 % +of the impact energy, 180 J"),
            ContainsRegex("Peak strain rate +")));
  EXPECT_THAT(
      in_markdown(test::example_summary()),
      HasSubstr("| to a tolerance of 0.01 % for peak forces, distances and rebound: 240 steps, 80 sampling "
                "points, 3 runs, 0.8 ms | dashpad "));
  EXPECT_THAT(in_markdown(test::example_summary()), HasSubstr(" | energy residual 0.005 % |"));
}

TEST(SummaryText, SaysWhatTheWeightAddsToTheEnergy) {
  Summary summary = test::example_summary();
  summary.energy.weight = 25;
  EXPECT_THAT(shown(summary),
              ContainsRegex("of the impact\\s+energy,\\s+180\\s+J;\\s+gravity\\s+adds\\s+25\\s+J"));
}

TEST(SummaryText, SpeaksTheUnitsOfTheReport) {
  EXPECT_THAT(shown(test::example_summary(), "us"),
              AllOf(ContainsRegex("Peak force +1296.9 lbf"), ContainsRegex("Peak penetration +0.80000 in"),
                    ContainsRegex("Rebound speed +19.245 mph"), HasSubstr("1593.1 in·lbf")));
  EXPECT_THAT(
      shown(test::example_summary(), "us", Detail::main),
      AllOf(HasSubstr("of mass 9.9208 lb and radius 3 in strikes, at 20 mph,"), HasSubstr(", 1 in thick")));
}

TEST(SummaryText, SpeaksTheUnitsOfCrashLaboratories) {
  EXPECT_THAT(shown(test::example_summary(), "engineering-metric"),
              AllOf(ContainsRegex("Peak force +5.7688 kN"), ContainsRegex("Rebound speed +30.971 km/h")));
  EXPECT_THAT(shown(test::example_summary(), "engineering-metric", Detail::main),
              AllOf(HasSubstr("strikes, at 32.187 km/h"), HasSubstr("0.105 kN/mm")));
}

TEST(SummaryText, SaysThatThePadBottomedOut) {
  EXPECT_THAT(
      shown(test::bottomed_out_summary()),
      AllOf(HasSubstr("bottomed out"),
            HasSubstr("BOTTOMED at 5.9307 ms with the impactor still moving at 5.05 m/s"),
            ContainsRegex("Peak force +none"), Not(HasSubstr("Rebound speed")), Not(HasSubstr("nan"))));
}

TEST(SummaryText, TellsNearlyBottomedFromBottomed) {
  Summary summary = test::example_summary();
  summary.peak_penetration = 0.0254 * (1 - 2e-9);
  EXPECT_THAT(shown(summary), AllOf(HasSubstr("all but 2e-07 % of the pad"), Not(HasSubstr("BOTTOMED"))));
}

TEST(SummaryText, SaysWhyAResultIsExtrapolated) {
  Summary summary = test::example_summary();
  EXPECT_THAT(shown(summary), Not(HasSubstr("EXTRAPOLATED")));
  summary.extrapolations = {{Beyond::strain, "strain 0.98 is above 0.9"},
                            {Beyond::rate, "rate 312 1/s is above 100 1/s"}};
  EXPECT_THAT(shown(summary), AllOf(HasSubstr("EXTRAPOLATED STRAIN: strain 0.98 is above 0.9\n"),
                                    HasSubstr("EXTRAPOLATED RATE: rate 312 1/s is above 100 1/s\n")));
}

TEST(SummaryText, WarnsOfFiguresThatCannotBeTrusted) {
  Summary summary = test::example_summary();
  summary.status = Status::tolerance_not_met;
  summary.errors.peak_force = std::numeric_limits<double>::infinity();
  EXPECT_THAT(shown(summary), AllOf(HasSubstr("TOLERANCE NOT MET"), HasSubstr("± unknown")));
  EXPECT_THAT(in_markdown(summary), HasSubstr("without meeting the tolerance of 0.01 %"));
}

/// A rigid foam on a rigid support: its run ends with a release, from which nothing rebounds.
TEST(SummaryText, SaysThatThePadStoppedTheImpactorAlsoWithTheToleranceMissed) {
  Summary summary = test::example_summary();
  summary.contact_end.reset();
  for (const Status status : {Status::released, Status::tolerance_not_met}) {
    summary.status = status;
    EXPECT_THAT(shown(summary), AllOf(HasSubstr("\nThe pad stopped the impactor without pushing it back.\n"),
                                      Not(HasSubstr("rebounded"))));
  }
  summary.release.reset();
  EXPECT_THAT(shown(summary), HasSubstr("\nThe computation stopped before the impactor left the pad.\n"));
}

/// On a rigid support nothing gives way, also where the tolerance was missed on the way there.
TEST(SummaryText, TellsARigidSupportFromOneThatYieldsAlsoWithTheToleranceMissed) {
  Summary summary = test::bottomed_out_summary();
  for (const Status status : {Status::bottomed_out, Status::tolerance_not_met}) {
    summary.status = status;
    EXPECT_THAT(shown(summary),
                AllOf(ContainsRegex("5.05 m/s;\\s+the\\s+figures\\s+cover\\s+the\\s+time\\s+until\\s+then"),
                      Not(HasSubstr("yielded"))));
  }
  summary = test::example_summary();
  summary.bottomed = Moment{.time = 0.0059307, .velocity = 5.05};
  EXPECT_THAT(shown(summary), ContainsRegex("only\\s+the\\s+support\\s+yielded"));
}

TEST(SummaryText, WarnsOfTheTimeLimit) {
  Summary summary = test::example_summary();
  summary.status = Status::time_limit;
  summary.contact_end.reset();
  summary.rebound_speed.reset();
  EXPECT_THAT(shown(summary), HasSubstr("TIME LIMIT"));
}

TEST(SummaryText, ShowsNoFiguresOfARunThatNeverWas) {
  EXPECT_THAT(shown(Summary{}), AllOf(HasSubstr("Nothing was computed."), Not(HasSubstr("Peak"))));
}

TEST(SummaryText, KeepsControlCharactersOfATitleFromTheTerminal) {
  ImpactCase impact = test::example_case();
  impact.title = "a\x1b[2Jb\nc";
  EXPECT_THAT(test::impact_text(impact, test::example_summary(), {}, unit_system("si"), Detail::main),
              HasSubstr("\na [2Jb c\n"));
}

TEST(CaseText, NamesTheSupport) {
  ImpactCase impact = test::example_case();
  impact.support = Support::rigid();
  EXPECT_THAT(output::case_text(impact, unit_system("si")), HasSubstr("on a rigid support."));
  impact.support = Support::through({{0.001, 100}, {0.002, 900}});
  EXPECT_THAT(output::case_text(impact, unit_system("si")),
              HasSubstr("a support with a force curve of 2 points (up to 900 N at 2 mm)."));
}

TEST(CaseText, EchoesEveryValueInSI) {
  EXPECT_THAT(output::case_in_si(test::example_case(), Options{}),
              AllOf(HasSubstr("impactor.speed = 8.9408 m/s\n"),
                    HasSubstr("pad.parameters.initial_modulus = 200000 Pa\n"),
                    HasSubstr("pad.parameters.relaxation_time = 0.0003333333333333333 s\n"),
                    HasSubstr("support = linear, 105000 N/m\n"), HasSubstr("solver.tolerance = 0.0001\n")));
}

TEST(MaterialText, ShowsParametersSourceAndRange) {
  EXPECT_THAT(
      output::to_terminal(output::material_document(test::example_case().pad.material, unit_system("us")),
                          output::Detail::main),
      AllOf(HasSubstr("made up for a test"), ContainsRegex("initial_modulus +E_0 +29.008 +psi"),
            HasSubstr("up to a strain of 0.9 and at strain rates from 1 to 100 1/s")));
}

TEST(UnitSystem, RefusesAnUnknownNameAndSaysWhichThereAre) {
  try {
    unit_system("imperial");
    FAIL() << "accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_THAT(error.what(), AllOf(HasSubstr("imperial"), HasSubstr("si, us, engineering-metric")));
  }
}

}  // namespace
}  // namespace dashpad
