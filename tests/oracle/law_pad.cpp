#include "oracle/law_pad.hpp"

#include <optional>
#include <utility>
#include <vector>

#include "oracle/law_formulas.hpp"
#include "oracle/law_loading.hpp"
#include "oracle/law_unloading.hpp"
#include "oracle/speed_root.hpp"

namespace dashpad::oracle {
namespace {

/// Until the pad first turns what is remembered is the stress over A, from then on the stress.
template <class Formulas>
class LawPad final : public PadModel {
 public:
  LawPad(const Formulas& law, Outline nose, double thickness, int fineness, double deepest)
      : PadModel(std::move(nose), thickness, fineness),
        law_(law),
        scale_(law.edge(law.at_rate(0))),
        deepest_(deepest),
        loading_(law, this->nose(), thickness, fineness, 1 - deepest / thickness) {}
  [[nodiscard]] std::size_t unknowns() const override {
    return back_ ? back_->depths().size() : loading_.unknowns();
  }
  [[nodiscard]] bool needs_speed() const override { return true; }
  [[nodiscard]] bool has_rates() const override { return true; }
  double begin(double* memory, double speed) override {
    std::fill_n(memory, unknowns(), law_.edge(law_.at_rate(speed / thickness())));
    return 1e-9 * thickness();
  }
  [[nodiscard]] std::vector<double> turned(double y, const double* memory) override {
    if (back_) return {};
    back_.emplace(law_, nose(), thickness(), fineness(), y, std::fmax(y, deepest_));
    std::vector<double> stresses;
    for (const double depth : back_->depths()) stresses.push_back(loading_.stress(y, depth, memory));
    return stresses;
  }
  [[nodiscard]] Pressed pressed(double y, const double* memory, bool) const override {
    if (!(y > 0)) return {0, 0, std::min(y / thickness(), -1e-300)};
    if (back_) return back_->pressed(y, memory);
    loading_.prepare(y, memory, {});
    return {loading_.force(), nose().area(y), loading_.stress(y, 0, memory)};
  }
  void rates(double y, double speed, double time, const double* memory, double* slope) const override {
    if (back_) {
      back_->prepare(y, largest(), time);
      const auto rate = law_.at_rate(speed / thickness());
      for (std::size_t j = 0; j < unknowns(); ++j) slope[j] = back_->rate(j, rate, memory);
    } else {
      loading_.rates(y, time, law_.at_rate(std::fmax(speed, 0) / thickness()), memory, slope);
    }
  }
  void prepare(double y, double time, const double* memory) const override {
    memory_ = memory;
    if (back_)
      back_->prepare(y, largest(), time);
    else
      loading_.prepare(y, memory, time);
  }
  [[nodiscard]] double force_rate(double log_speed, int way) const override {
    const double speed = log_speed <= log_of_no_speed ? 0 : std::exp(log_speed);
    const auto rate = speed == 0 ? law_.at_rate(0)
                      : way > 0  ? law_.at_rate(speed / thickness(), log_speed - std::log(thickness()))
                                 : law_.at_rate(-speed / thickness());
    return back_ ? back_->force_rate(rate, memory_) : loading_.force_rate(rate, way * speed);
  }
  void allowances(double relative, const double* memory, double* allowance) const override {
    constexpr double let_go = 1e4;  // less of columns that have
    for (std::size_t j = 0; j < unknowns(); ++j)
      allowance[j] = !back_ || memory[j] > 0 ? relative * scale_ : let_go * relative * scale_;
  }

 protected:
  void remember(double y, const double*) override {
    if (back_) back_->note(y);
  }

 private:
  Formulas law_;
  double scale_, deepest_;
  mutable LawLoading<Formulas> loading_;
  mutable std::optional<LawUnloading<Formulas>> back_;
  mutable const double* memory_ = nullptr;
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
