#include "dashpad/report1986/validation/energy.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "report1986/validation/placings.hpp"

namespace dashpad::report1986 {

namespace {

/// Collects claims, taking printed values from the data.
class Claims {
 public:
  explicit Claims(const ValidationData& data) : data_(data) {}

  void add(std::string where, std::string claim, const std::string& constant, double computed,
           double tolerance, std::string remark = "") {
    const double printed = data_.constant(constant);
    const std::string& unit = std::ranges::find(data_.printed, constant, &PrintedConstant::name)->unit;
    add({std::move(where), std::move(claim), unit, printed, computed, tolerance, false, std::move(remark)});
  }
  void add(ReportClaim claim) {
    claim.agrees = std::abs(claim.computed - claim.printed) <= claim.tolerance;
    claims_.push_back(std::move(claim));
  }
  [[nodiscard]] double constant(const std::string& name) const { return data_.constant(name); }
  std::vector<ReportClaim> take() { return std::move(claims_); }

 private:
  const ValidationData& data_;
  std::vector<ReportClaim> claims_;
};

double count_tests(const ValidationData& data, const std::vector<Projectile>& projectiles,
                   const std::vector<TestSupport>& supports) {
  return static_cast<double>(std::ranges::count_if(data.measured.tests, [&](const MeasuredTest& test) {
    return std::ranges::count(projectiles, test.projectile) > 0 &&
           std::ranges::count(supports, test.support) > 0;
  }));
}

/// The number of readings of a column, including those whose tests are lost.
double count_readings(const ValidationData& data, const std::string& column) {
  const auto reading = measured_column(column).reading;
  std::size_t count = 0;
  for (const MeasuredTest& test : data.measured.tests) count += (test.*reading).has_value() ? 1 : 0;
  for (const UnplacedReadings& group : data.measured.unplaced)
    if (group.column == column) count += group.readings.size();
  return static_cast<double>(count);
}

void claim_counts(const ValidationData& data, Claims& claims) {
  using enum Projectile;
  using enum TestSupport;
  const std::string where = "section 3.2";
  claims.add(where, "tests", "tests", count_tests(data, {aluminium, steel}, {load_cell, plate}), 0);
  claims.add(where, "tests on the load cell", "load_cell_tests",
             count_tests(data, {aluminium, steel}, {load_cell}), 0);
  claims.add(where, "of these, with the aluminium projectile", "aluminium_load_cell_tests",
             count_tests(data, {aluminium}, {load_cell}), 0);
  claims.add(where, "of these, with the steel projectile", "steel_load_cell_tests",
             count_tests(data, {steel}, {load_cell}), 0);
  claims.add(where, "tests on the flexible plate, aluminium projectile", "plate_tests",
             count_tests(data, {aluminium}, {plate}), 0);
  claims.add(where, "peak forces measured", "force_readings", count_readings(data, "peak_force_lb"), 0);

  const double both = claims.constant("strains_by_both");
  claims.add({where, "peak strains from the clay plug", "1", claims.constant("plug_only_strains") + both,
              count_readings(data, "plug_strain"), 0, false, "the scan of Table 3-1 contains fewer"});
  claims.add({where, "peak strains from the contact diameter", "1", both,
              count_readings(data, "diameter_strain"), 0, false, "the scan of Table 3-1 contains fewer"});

  const auto energies = std::ranges::count_if(data.measured.tests, [](const MeasuredTest& test) {
    const double energy = impact_energy_in_lb(test.weight_lb, test.speed_mph);
    const bool is_whole = test.energy_in_lb == std::floor(test.energy_in_lb);  // or has one decimal
    return std::abs(test.energy_in_lb - energy) <= (is_whole ? 0.5 : 0.05);
  });
  claims.add("Table 3-1", "tests whose kinetic energy is M V^2/2 to the last printed digit", "tests",
             static_cast<double>(energies), 0,
             "one of the speeds of tests 9 to 11 and that of test 24 were derived from the energies");
}

void claim_times(const ValidationData& data, Claims& claims) {
  const std::string where = "section 3.3, Eq. 32";
  const double soft = claims.constant("load_cell_first_slope_lb_per_in");
  const double stiff = claims.constant("load_cell_last_slope_lb_per_in");
  const double light = weight_of(data, Projectile::aluminium);
  const double heavy = weight_of(data, Projectile::steel);
  claims.add(where, "shortest time to peak on the load cell alone: aluminium, 90,000 lb/in",
             "shortest_elastic_time_ms", elastic_time_to_peak_ms(light, stiff), 0.05,
             "the text cites Eq. 30");
  claims.add(where, "longest time to peak on the load cell alone: steel, 9,000 lb/in",
             "longest_elastic_time_ms", elastic_time_to_peak_ms(heavy, soft), 0.05,
             fmt::format("neither projectile gives this; the aluminium one takes {:.2f} ms at 9,000 lb/in",
                         elastic_time_to_peak_ms(light, soft)));

  const auto [slow, fast] = std::ranges::minmax(data.measured.tests, {}, &MeasuredTest::speed_mph);
  const double excess = claims.constant("travel_in") - claims.constant("expected_travel_in");
  const auto excess_ms = [&](double speed_mph) { return 1e3 * excess / (inch_per_s_of_mph * speed_mph); };
  claims.add("section 3.3", "shortest time between the lines VT = 1.65 in and 1.25 in",
             "least_excess_time_ms", excess_ms(fast.speed_mph), 0.5, "at the highest test speed");
  claims.add("section 3.3", "longest time between these lines", "greatest_excess_time_ms",
             excess_ms(slow.speed_mph), 0.5, "at the lowest test speed");
}

void claim_plate(const ValidationData& data, Claims& claims) {
  const double force =
      elastic_peak_force_lb(weight_of(data, Projectile::aluminium), claims.constant("plate_speed_mph"),
                            data.plate_stiffness_lb_per_in);
  claims.add("section 3.3", "rebound speeds in Figure 3-7", "rebound_readings",
             count_readings(data, "rebound_mph"), 0,
             "the figure is said to show all tests; the scan of Table 3-1 contains fewer");
  claims.add("section 3.3, Eq. 34", "peak force on the plate, treated as an elastic system, at 19.6 mph",
             "plate_peak_force_lb", force, 0.5, "the text cites Eq. 32");
  claims.add("section 3.3", "deflection of the plate at that force", "plate_deflection_in",
             force / data.plate_stiffness_lb_per_in, 0.05, "\"about one half inch\"");
}

void claim_storage(const ValidationData& data, Claims& claims) {
  const auto share = [&](const MeasuredTest& test) {
    return support_energy_in_lb(data.load_cell, *test.peak_force_lb) / test.energy_in_lb;
  };
  std::vector<MeasuredTest> tests;
  for (const MeasuredTest& test : data.measured.tests)
    if (test.peak_force_lb) tests.push_back(test);
  if (tests.empty()) return;
  const auto [least, greatest] = std::ranges::minmax(tests, {}, share);
  const std::string where = "section 3.3, Eq. 35";
  claims.add(where, "smallest share of the impact energy stored in the load cell", "least_storage_fraction",
             share(least), 0.005,
             fmt::format("test {}, among the tests whose force is known; test {} gives {:.3f}", least.number,
                         tests.front().number, share(tests.front())));
  claims.add(where, "largest share", "greatest_storage_fraction", share(greatest), 0.05,
             fmt::format("test {}; \"about 30 percent\"", greatest.number));
}

/// Adds the claims of one column of Table 3-2. The tolerance is half a unit of the last digit; the aluminium
/// column has fewer digits.
void claim_table_3_2(const ValidationData& data, const ExpectationExample& printed, Claims& claims) {
  const bool is_steel = printed.projectile == Projectile::steel;
  const ExpectationExample computed =
      expectation(data, printed.projectile, printed.speed_mph, printed.peak_force_lb,
                  claims.constant("rebound_ratio_load_cell"));
  const auto add = [&](const char* what, const char* unit, double ExpectationExample::*figure,
                       double tolerance, std::string remark = "") {
    claims.add({"Table 3-2",
                fmt::format("{}, {} {:g} mph", what, to_string(printed.projectile), printed.speed_mph), unit,
                printed.*figure, computed.*figure, tolerance, false, std::move(remark)});
  };
  add("U", "in.lb", &ExpectationExample::energy_in_lb, is_steel ? 0.5 : 5);
  if (printed.energy_in_lb > claims.constant("energy_trend_from_in_lb"))
    claims.add({"Table 3-2, Eq. 36", fmt::format("F from the trend, {:g} in.lb", printed.energy_in_lb), "lb",
                printed.peak_force_lb,
                trend_force_lb(printed.energy_in_lb, claims.constant("energy_trend_factor"),
                               claims.constant("energy_trend_exponent")),
                50, false, ""});
  add("U_R", "in.lb", &ExpectationExample::rebound_energy_in_lb, 0.5);
  add("W_S", "in.lb", &ExpectationExample::support_energy_in_lb, 0.5,
      is_steel ? "the reconstructed load-cell curve was drawn through this value"
               : fmt::format("the slope that would store this energy is {:.0f} lb/in, not 9,000",
                             std::pow(printed.peak_force_lb, 2) / (2 * printed.support_energy_in_lb)));
  add("V_R*/V", "1", &ExpectationExample::speed_ratio, is_steel ? 0.005 : 0.05,
      fmt::format("sqrt((U_R + W_S)/U), as in the text; the formula in the table lacks the square root and "
                  "gives {:.2f}",
                  std::pow(computed.speed_ratio, 2)));
  add("V_R*", "mph", &ExpectationExample::rebound_mph, is_steel ? 0.05 : 0.5);
}

void claim_stiffness(const ValidationData& data, Claims& claims) {
  const double excess = claims.constant("excess_of_predicted_time_ms");
  const auto add_stiffness = [&](const std::string& name, Projectile projectile) {
    claims.add("section 4, Eq. 32", "stiffness corresponding to 2 ms, " + name,
               "stiffness_of_time_" + name + "_lb_per_in",
               stiffness_of_time(weight_of(data, projectile), excess), 50, "the text cites Eq. 30");
  };
  add_stiffness("aluminium", Projectile::aluminium);
  add_stiffness("steel", Projectile::steel);

  for (const std::string name : {"aluminium", "steel"})
    for (const std::string speed : {"low", "high"}) {
      const double support = claims.constant(speed == "low" ? "load_cell_first_slope_lb_per_in"
                                                            : "load_cell_last_slope_lb_per_in");
      const double ratio = std::sqrt(claims.constant("stiffness_of_time_" + name + "_lb_per_in") / support);
      claims.add("section 4", fmt::format("expected force ratio from sqrt(K), {}, {} speed", name, speed),
                 fmt::format("expected_force_ratio_{}_{}_speed", name, speed), ratio, 0.05);
    }
}

}  // namespace

std::vector<ReportClaim> check_claims(const ValidationData& data) {
  Claims claims(data);
  claim_counts(data, claims);
  claim_times(data, claims);
  claim_plate(data, claims);
  claim_storage(data, claims);
  for (const ExpectationExample& example : data.table_3_2) claim_table_3_2(data, example, claims);
  claim_stiffness(data, claims);
  return claims.take();
}

}  // namespace dashpad::report1986
