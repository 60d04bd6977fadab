#include "oracle/layered_impact.hpp"

#include <algorithm>
#include <cmath>

namespace dashpad::oracle {
namespace {

using Numbers = std::vector<double>;

/// Where an increasing function is zero, between two places.
template <class F>
double bisected(F&& f, double low, double high) {
  for (int i = 0; i < 200 && high - low > 1e-13 * high; ++i) {
    const double middle = low + (high - low) / 2;
    (f(middle) > 0 ? high : low) = middle;
  }
  return low + (high - low) / 2;
}

class Column {
 public:
  explicit Column(const std::vector<FoamInLayer>& layers) : layers_(layers), largest_(layers.size(), 0.0) {}

  struct Answer {
    double stress = 0;
    Numbers strain;
  };
  /// `slipped`: p of each layer. The stress is sought near that of the last answer.
  Answer at(double y, const Numbers& slipped) {
    const auto excess = [&](double stress) {
      double sum = -y;
      for (std::size_t i = 0; i < layers_.size(); ++i)
        sum += layers_[i].thickness * strain(i, stress, slipped[i]);
      return sum;
    };
    double low = 0, high = std::max(last_, 1.0);
    while (excess(high) < 0) low = high, high *= 2;
    if (low == 0 && excess(high / 2) < 0) low = high / 2;
    Answer answer;
    answer.stress = last_ = bisected(excess, low, high);
    for (std::size_t i = 0; i < layers_.size(); ++i) answer.strain.push_back(strain(i, last_, slipped[i]));
    return answer;
  }
  void remember(const Numbers& strain) {
    for (std::size_t i = 0; i < strain.size(); ++i) largest_[i] = std::max(largest_[i], strain[i]);
  }

 private:
  [[nodiscard]] double strain(std::size_t i, double stress, double slipped) const {
    const FoamFormulas& foam = *layers_[i].foam;
    // The lag is short: the strain lies within a few of it about what has slipped.
    const auto excess = [&](double e) {
      return foam.stress(e, 1 - e, std::max(largest_[i] - e, 0.0), foam.slip_rate(e - slipped)) - stress;
    };
    const double reach = 30 * foam.lag();
    return bisected(excess, std::max(slipped - reach, 1e-12), slipped + reach);
  }

  const std::vector<FoamInLayer>& layers_;
  Numbers largest_;
  double last_ = 0;
};

/// y, V, then p of each layer.
class Motion {
 public:
  Motion(const LayeredRun& run, const std::vector<FoamInLayer>& layers)
      : run_(run), layers_(layers), column_(layers) {}

  Numbers rate(const Numbers& state) {
    last_ = column_.at(state[0], {state.begin() + 2, state.end()});
    Numbers rate{state[1], -run_.area * last_.stress / run_.mass};
    for (std::size_t i = 0; i < layers_.size(); ++i)
      rate.push_back(layers_[i].foam->slip_rate(last_.strain[i] - state[i + 2]));
    return rate;
  }
  [[nodiscard]] const Column::Answer& last() const { return last_; }
  void remember() { column_.remember(last_.strain); }

 private:
  const LayeredRun& run_;
  const std::vector<FoamInLayer>& layers_;
  Column column_;
  Column::Answer last_;
};

Numbers moved(const Numbers& from, const Numbers& rate, double time) {
  Numbers to = from;
  for (std::size_t i = 0; i < to.size(); ++i) to[i] += time * rate[i];
  return to;
}

}  // namespace

LayeredPeaks solve_layers(const LayeredRun& run, const std::vector<FoamInLayer>& layers) {
  Motion motion(run, layers);
  Numbers state(2 + layers.size(), 0.0);
  state[1] = run.speed;
  LayeredPeaks peaks;
  peaks.strain.assign(layers.size(), 0.0);
  const double h = run.step;
  for (bool begun = false; state[0] > 0 || !begun; begun = true) {
    const Numbers a = motion.rate(state);
    motion.remember();
    const Column::Answer& now = motion.last();
    const double force = run.area * now.stress;
    peaks.force = std::max(peaks.force, force);
    for (std::size_t i = 0; i < layers.size(); ++i)
      peaks.strain[i] = std::max(peaks.strain[i], now.strain[i]);
    if (begun && state[1] < 0 && force < 1e-9 * peaks.force) break;
    const Numbers b = motion.rate(moved(state, a, h / 2));
    const Numbers c = motion.rate(moved(state, b, h / 2));
    const Numbers d = motion.rate(moved(state, c, h));
    for (std::size_t i = 0; i < state.size(); ++i) state[i] += h / 6 * (a[i] + 2 * b[i] + 2 * c[i] + d[i]);
    peaks.penetration = std::max(peaks.penetration, state[0]);
  }
  peaks.rebound_speed = -state[1];
  return peaks;
}

}  // namespace dashpad::oracle
