#include "oracle/law_pad.hpp"

#include <numbers>
#include <utility>
#include <vector>

#include "oracle/law_formulas.hpp"

namespace dashpad::oracle {
namespace {

/// Until the pad first turns what is remembered is the stress over A, which is smooth where a column is just
/// touched; from then on the stress.
template <class Formulas>
class LawPad final : public PadModel {
 public:
  LawPad(const Formulas& law, Outline nose, double thickness, int fineness, double deepest)
      : PadModel(std::move(nose), thickness, fineness), law_(law), scale_(law.edge(law.at_rate(0))) {
    const int cells = 160 * fineness;
    const double last = std::fmin(this->nose().end, deepest);
    const int count = last > 0 ? cells : 0;
    for (int i = 0; i <= count; ++i) {
      // Close at both ends: the axis closes, and at the edge the stress is a power of the depth.
      depth_.push_back(count > 0 ? last * (1 - std::cos(std::numbers::pi * i / count)) / 2 : 0);
      area_.push_back(this->nose().area(depth_.back()));
    }
  }
  [[nodiscard]] std::size_t unknowns() const override { return depth_.size(); }
  [[nodiscard]] bool needs_speed() const override { return true; }
  double begin(double* memory, double speed) override {
    std::fill_n(memory, depth_.size(), law_.edge(law_.at_rate(speed / thickness())));
    return 0;
  }
  void turned(double y, double* memory) override {
    if (turned_) return;
    turned_ = true;
    for (std::size_t j = 0; j < depth_.size(); ++j)
      memory[j] = y > depth_[j] ? memory[j] * point(y, depth_[j]).shape : 0;
  }
  [[nodiscard]] Pressed pressed(double y, const double* memory, bool with_area) const override {
    if (turned_) return by_stresses(y, memory);
    return pressed_by(
        nose(), y, thickness(), {}, true, with_area, fineness(), [&](double strain, double complement) {
          if (strain <= 0) return 0.0;
          const double depth = y - strain * thickness();
          const auto [j, share] = between(depth_, depth);
          const double ratio = share > 0 ? memory[j] + share * (memory[j + 1] - memory[j]) : memory[j];
          return strain_point(strain, complement, law_.m(), law_.n()).shape * ratio;
        });
  }
  void rates(double y, double speed, double time, const double* memory, double* slope) const override {
    const auto rate = law_.at_rate(turned_ ? speed / thickness() : std::fmax(speed, 0) / thickness());
    for (std::size_t j = 0; j < depth_.size(); ++j)
      slope[j] = turned_ ? rate_of_stress(y, depth_[j], rate, time, memory[j])
                         : rate_of_ratio(y, depth_[j], rate, time, memory[j]);
  }
  void allowances(double relative, double* allowance) const override {
    std::fill_n(allowance, unknowns(), relative * scale_);
  }

 private:
  using Rate = typename Formulas::Rate;
  static constexpr double least = 1e-4;  ///< strain from which on a column counts as touched

  [[nodiscard]] StrainPoint point(double y, double depth) const {
    const double strain = std::fmax((y - depth) / thickness(), 1e-9);
    return strain_point(strain, (thickness() - y + depth) / thickness(), law_.m(), law_.n());
  }
  [[nodiscard]] double rate_of_ratio(double y, double depth, const Rate& rate, double time,
                                     double ratio) const {
    const double edge = law_.edge(rate);
    if (y <= depth) return (edge - ratio) * std::fabs(rate.rate) / least;
    const StrainPoint at = point(y, depth);
    const double steep = std::fmin(at.log_slope, 1 / least);
    return (edge - ratio) * steep * rate.rate +
           law_.regular(at, law_.at_strain(at), rate, ratio, relaxation(time, at));
  }
  [[nodiscard]] double rate_of_stress(double y, double depth, const Rate& rate, double time,
                                      double stress) const {
    if (y <= depth) return 0;
    const StrainPoint at = point(y, depth);
    const double before = (largest() - depth) / thickness();
    const Envelope envelope = law_.envelope(at, law_.at_strain(at), rate, before);
    // A column that has let go does not press again of itself (Eq. 7).
    if (stress <= 0 && envelope.value < 0) return 0;
    return law_.envelope_rate(envelope, rate) + relaxation(time, at) * (envelope.value - stress);
  }
  [[nodiscard]] double relaxation(double time, const StrainPoint& at) const {
    return law_.relaxation(std::fmax(time, 1e-9), at.strain);
  }
  [[nodiscard]] Pressed by_stresses(double y, const double* memory) const {
    if (y <= 0) return {0, 0, std::min(y / thickness(), -1e-300)};
    Pressed all;
    double here = memory[0];
    all.most = here;
    if (nose().tip > 0 && here > 0) all.force = nose().tip * here, all.area = nose().tip;
    for (std::size_t j = 0; j + 1 < depth_.size() && depth_[j] < y; ++j) {
      const double share = std::fmin((y - depth_[j]) / (depth_[j + 1] - depth_[j]), 1);
      const double next = share < 1 ? 0 : memory[j + 1], met = share * (area_[j + 1] - area_[j]);
      all.most = std::fmax(all.most, next);
      if (here > 0 && next > 0)
        all.force += met * (here + next) / 2, all.area += met;
      else if (here > 0 || next > 0) {
        const double part = std::fmax(here, next) / (std::fabs(here) + std::fabs(next));
        all.force += met * part * std::fmax(here, next) / 2, all.area += met * part;
      }
      here = next;
    }
    return all;
  }

  Formulas law_;
  double scale_;
  std::vector<double> depth_, area_;
  bool turned_ = false;
};

}  // namespace

std::unique_ptr<PadModel> law_pad(const NineParameter& law, Outline nose, double thickness, int fineness,
                                  double deepest) {
  return std::make_unique<LawPad<NineFormulas>>(NineFormulas(law), std::move(nose), thickness, fineness,
                                                deepest);
}
std::unique_ptr<PadModel> law_pad(const TwentyOneParameter& law, Outline nose, double thickness, int fineness,
                                  double deepest) {
  return std::make_unique<LawPad<TwentyOneFormulas>>(TwentyOneFormulas(law), std::move(nose), thickness,
                                                     fineness, deepest);
}

}  // namespace dashpad::oracle
