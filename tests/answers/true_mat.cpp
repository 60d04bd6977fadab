#include "answers/true_mat.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "dashpad/impact/solution.hpp"
#include "dashpad/injury/metrics.hpp"
#include "study/sampling.hpp"

namespace dashpad::test {
namespace {

constexpr double pi = 3.141592653589793;
constexpr double slowest_rate = 0.01;     // 1/s
constexpr double max_strain = 0.985;      // of the room that a column has
constexpr double max_time = 0.12;         // s
constexpr double sensor_interval = 5e-5;  // s
constexpr double sensor_noise = 0.005;    // of the peak

double curve(const TrueMat& mat, double strain) {
  const double plateau = mat.plateau * -std::expm1(-mat.modulus / mat.plateau * strain);
  return mat.law == TrueLaw::enclosed_air
             ? plateau
             : plateau + mat.densification * std::pow(strain / (1 - strain), mat.exponent);
}

/// What is left of the stress on the way back, by how far it has gone.
double left(double loss, double strain, double largest) {
  const double way = strain / largest;
  return strain < largest - 1e-9 ? 1 - loss + loss * way * way : 1;
}

/// One column, step by step.
struct Column {
  double strain = 0, largest = 0, curve_before = 0, branch = 0;

  /// Stress at the end of a step to that strain.
  double step_to(const TrueMat& mat, double next, double step) {
    const double rate = std::max((next - strain) / step, 0.0) / slowest_rate;
    const double here = curve(mat, next);
    largest = std::max(largest, next);
    strain = next;
    const double loading = left(mat.loss, next, std::max(largest, 1e-9));
    double stress = 0;
    if (mat.law == TrueLaw::enclosed_air) {
      const double air = mat.densification * next / (1 - next - mat.exponent);
      stress = here * std::pow(1 + rate, mat.rate_factor + mat.rate_growth * next) * loading +
               air * left(mat.loss_of_air, next, std::max(largest, 1e-9));
    } else {
      branch = (branch + mat.branch * (here - curve_before)) * std::exp(-step / mat.branch_time);
      stress = here * (1 + mat.rate_factor * std::log1p(rate)) * loading + branch;
    }
    curve_before = here;
    return next > 0 ? std::max(stress, 0.0) : 0;
  }
};

class Draws {
 public:
  explicit Draws(std::uint64_t seed, std::uint32_t stream = 0) : seed_(seed), stream_(stream) {}
  double even() { return study::random_fraction(seed_, place_++, stream_, study::Purpose::draw); }
  double between(double low, double high) { return low + (high - low) * even(); }
  double normal() {
    const double u = even();
    return std::sqrt(-2 * std::log(u)) * std::cos(2 * pi * even());
  }

 private:
  std::uint64_t seed_;
  std::uint32_t stream_;
  std::uint64_t place_ = 0;
};

/// The height from which a drop reaches a strain.
double height_for(const TrueMat& mat, double strain) {
  double low = std::log(0.1), high = std::log(6.0);
  for (int i = 0; i < 14; ++i) {
    const double middle = (low + high) / 2;
    (dropped(mat, std::exp(middle), {60, 2e-5}).largest_strain < strain ? low : high) = middle;
  }
  return std::exp((low + high) / 2);
}

}  // namespace

TrueDrop dropped(const TrueMat& mat, double height, Fineness fineness) {
  const double ring = missile_radius / fineness.columns;
  const double room = mat.law == TrueLaw::enclosed_air ? 1 - mat.exponent : 1;
  std::vector<Column> columns(static_cast<std::size_t>(fineness.columns));
  double speed = std::sqrt(2 * standard_gravity * height), place = 0, time = 0;
  TrueDrop drop;
  drop.pulse = {{0}, {0}};
  while (time < max_time) {
    place += speed * fineness.step;
    double force = 0;
    for (std::size_t i = 0; i < columns.size(); ++i) {
      const double radius = (static_cast<double>(i) + 0.5) * ring;
      const double depth =
          place - missile_radius + std::sqrt(missile_radius * missile_radius - radius * radius);
      if (depth <= 0 && columns[i].largest == 0) break;  // nor do those farther out
      const double strain = std::clamp(depth / mat.thickness, 0.0, max_strain * room);
      force += columns[i].step_to(mat, strain, fineness.step) * 2 * pi * radius * ring;
      drop.largest_strain = std::max(drop.largest_strain, strain);
    }
    speed += (standard_gravity - force / missile_mass) * fineness.step;
    time += fineness.step;
    drop.pulse.time.push_back(time);
    drop.pulse.acceleration.push_back(-force / missile_mass);
    drop.peak = std::max(drop.peak, force / missile_mass);
    if (speed < 0 && force <= 0) break;
  }
  drop.hic = injury::hic(drop.pulse, injury::unlimited_window).value;
  return drop;
}

DrawnMat drawn_mat(TrueLaw law, std::uint64_t seed) {
  Draws draws(seed, law == TrueLaw::enclosed_air ? 1 : 0);
  TrueMat mat;
  mat.law = law;
  mat.thickness = draws.between(0.04, 0.08);
  mat.plateau = draws.between(50e3, 150e3);
  mat.modulus = draws.between(0.8e6, 3e6);
  mat.loss = draws.between(0.3, 0.7);
  if (law == TrueLaw::enclosed_air) {
    mat.densification = draws.between(30e3, 110e3);
    mat.exponent = draws.between(0.03, 0.1);
    mat.rate_factor = draws.between(0.02, 0.06);
    mat.rate_growth = draws.between(0.02, 0.08);
    mat.loss_of_air = draws.between(0.05, 0.35);
  } else {
    mat.densification = draws.between(40e3, 120e3);
    mat.exponent = draws.between(1.3, 2.2);
    mat.rate_factor = draws.between(0.02, 0.08);
    mat.branch = draws.between(0.1, 0.5);
    mat.branch_time = draws.between(3e-3, 12e-3);
  }
  DrawnMat drawn{.mat = mat};
  drawn.highest = height_for(mat, draws.between(0.7, 0.87));
  drawn.within = drawn.highest * draws.between(0.55, 0.95);
  drawn.beyond = 1.2 * drawn.highest;
  return drawn;
}

Pulse measured_pulse(const TrueDrop& drop, std::uint64_t seed, std::uint64_t which) {
  Draws draws(seed, static_cast<std::uint32_t>(10 + which));
  const Pulse& exact = drop.pulse;
  Pulse pulse;
  std::size_t after = 1;
  const double end = exact.time.back() + 0.01;
  for (double time = -0.01 + sensor_interval * draws.even(); time < end; time += sensor_interval) {
    double value = 0;
    if (time > 0 && time < exact.time.back()) {
      while (exact.time[after] < time) ++after;
      value = std::lerp(exact.acceleration[after - 1], exact.acceleration[after],
                        (time - exact.time[after - 1]) / (exact.time[after] - exact.time[after - 1]));
    }
    pulse.time.push_back(1 + time);
    pulse.acceleration.push_back(value + sensor_noise * drop.peak * draws.normal());
  }
  return pulse;
}

}  // namespace dashpad::test
