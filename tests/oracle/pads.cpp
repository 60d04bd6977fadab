#include "oracle/pads.hpp"

#include <array>
#include <functional>
#include <utility>
#include <vector>

#include "oracle/foam_formulas.hpp"
#include "oracle/law_pad.hpp"
#include "oracle/layer_pad.hpp"
#include "oracle/maxwell_impact.hpp"

namespace dashpad::oracle {
namespace {

/// Law 1.
class ElasticPad final : public PadModel {
 public:
  ElasticPad(Outline nose, double thickness, int fineness, double modulus)
      : PadModel(std::move(nose), thickness, fineness), modulus_(modulus) {}
  [[nodiscard]] Pressed pressed(double y, const double*, bool with_area) const override {
    return pressed_by(nose(), y, thickness(), {}, true, with_area, fineness(),
                      [&](double strain, double) { return modulus_ * strain; });
  }

 private:
  double modulus_;
};

/// Law 3 as the limit of a foam that is elastic, and very stiff, before it gives way and on the way back.
class RigidFoamPad final : public PadModel {
 public:
  RigidFoamPad(Outline nose, double thickness, int fineness, const RigidFoam& law, double earlier)
      : PadModel(std::move(nose), thickness, fineness),
        law_(law),
        stiff_(1e9 * law.crush_stress),
        earlier_(earlier) {
    begin_struck(earlier);
  }
  /// A new pad begins where it gives way, or below a flat tip its force would be that of a moment later.
  double begin(double*, double) override {
    return earlier_ > 0 ? earlier_ : thickness() * law_.crush_stress / stiff_;
  }
  [[nodiscard]] Pressed pressed(double y, const double*, bool with_area) const override {
    const double before = ahead(y);
    const std::vector<double> corners{law_.crush_strain, law_.crush_strain - before, law_.second_strain,
                                      law_.second_strain - before};
    Pressed all =
        pressed_by(nose(), y, thickness(), corners, false, false, fineness(), [&](double strain, double) {
          if (strain <= 0) return 0.0;
          return std::fmin(curve(strain + before), stiff_ * (strain + before)) - stiff_ * before;
        });
    // It keeps its shape, so that the nose lies against all of it until it leaves.
    if (with_area && all.force > 0) all.area = nose().area(y);
    return all;
  }
  [[nodiscard]] double little() const override { return 1e-11 * thickness(); }
  [[nodiscard]] bool holds() const override { return true; }

 private:
  [[nodiscard]] double curve(double e) const {
    const double s1 = law_.crush_stress, e1 = law_.crush_strain, s2 = law_.second_stress,
                 e2 = law_.second_strain;
    if (e <= e1) return s1;
    if (e <= e2) return s1 + (s2 - s1) * (e - e1) / (e2 - e1);
    return s2 + 9 * s2 / (1 - e2) * (e - e2);
  }
  RigidFoam law_;
  double stiff_, earlier_;
};

/// Eqs. 32 to 38 and 46 to 49: what is remembered is the strain that has slipped, one for all columns.
class FoamPad final : public PadModel {
 public:
  template <class Law>
  FoamPad(Outline nose, double thickness, int fineness, const Law& law, double earlier)
      : PadModel(std::move(nose), thickness, fineness), law_(law), earlier_(earlier), left_at_(earlier) {
    begin_struck(earlier);
  }
  [[nodiscard]] std::size_t unknowns() const override { return 1; }
  void left() override { left_at_ = largest(); }
  double begin(double* memory, double) override {
    double free = 0, met = earlier_;
    if (law_.stays_crushed() && earlier_ > 0) {
      for (int i = 0; i < 60; ++i) {
        const double y = (free + met) / 2;
        memory[0] = y / thickness();
        (pressed(y, memory, false).most > 0 ? met : free) = y;
      }
    } else {
      met = 0;
    }
    memory[0] = met / thickness();
    return met;
  }
  [[nodiscard]] Pressed pressed(double y, const double* memory, bool with_area) const override {
    const double u = slip_rate(y, memory), before = ahead(y);
    const bool in_crater = law_.stays_crushed() && left_at_ > 0 && largest() <= left_at_ && before > 0;
    std::vector<double> corners{law_.last_strain()};
    if (before > 0)
      for (const double largest : law_.corners()) corners.push_back(largest - before);
    return pressed_by(nose(), y, thickness(), corners, before == 0 && u >= 0, with_area, fineness(),
                      [&](double strain, double complement) {
                        const double all = law_.signed_stress(strain, complement, before, u);
                        if (!in_crater) return all;
                        const double lasting = law_.signed_stress(strain, complement, before, 0);
                        if (lasting <= 0 || strain <= 0) return lasting;
                        return lasting * (1 + (all - lasting) / law_.base(strain, complement));
                      });
  }
  void rates(double y, double, double, const double* memory, double* slope) const override {
    slope[0] = slip_rate(y, memory);
  }
  void allowances(double relative, const double*, double* allowance) const override {
    allowance[0] = relative * law_.lag();
  }
  [[nodiscard]] double little() const override { return 1e-3 * law_.lag() * thickness(); }

 private:
  [[nodiscard]] double slip_rate(double y, const double* memory) const {
    const double reach = 60 * law_.lag();
    return law_.slip_rate(std::clamp(y / thickness() - memory[0], -reach, reach));
  }
  FoamFormulas law_;
  double earlier_;
  double left_at_;  ///< largest penetration when the nose last left it, of any blow
};

/// Laws 2 and `viscoelastic-foam`: a branch is q = g (p - r) with dr/dt = (p - r) / tau at columns of fixed
/// depths, between which r is a line.
class MaxwellPad final : public PadModel {
 public:
  struct Branch {
    double share = 0, time = 1;
  };
  MaxwellPad(Outline nose, double thickness, int fineness, std::function<double(double)> lasting,
             std::vector<Branch> branches, double deepest)
      : PadModel(std::move(nose), thickness, fineness),
        lasting_(std::move(lasting)),
        branches_(std::move(branches)) {
    const int columns = 400 * fineness;
    const double last = std::fmin(this->nose().end, deepest);
    const int count = last > 0 ? columns : 0;
    for (int i = 0; i <= count; ++i) {
      const double share = count > 0 ? double(i) / count : 0;
      depth_.push_back(last * share * (0.002 + 0.998 * share));  // finest towards the axis, which closes
    }
    for (const Branch& branch : branches_) sudden_ += branch.share;
  }
  [[nodiscard]] std::size_t unknowns() const override { return branches_.size() * depth_.size(); }
  [[nodiscard]] Pressed pressed(double y, const double* memory, bool with_area) const override {
    return pressed_by(nose(), y, thickness(), {}, is_loading() && largest() <= y, with_area, fineness(),
                      [&](double strain, double) {
                        const double depth = y - strain * thickness();
                        return sudden_ * lasting_(strain) - remembered(depth, memory);
                      });
  }
  void rates(double y, double, double, const double* memory, double* slope) const override {
    for (std::size_t j = 0; j < depth_.size(); ++j) {
      const double lasting = lasting_(std::fmax(y - depth_[j], 0) / thickness());
      for (std::size_t i = 0; i < branches_.size(); ++i)
        slope[i * depth_.size() + j] = (lasting - memory[i * depth_.size() + j]) / branches_[i].time;
    }
  }
  void allowances(double relative, const double*, double* allowance) const override {
    std::fill_n(allowance, unknowns(), relative * lasting_(0.3));
  }

 private:
  [[nodiscard]] double remembered(double depth, const double* memory) const {
    const auto [j, share] = between(depth_, depth);
    double sum = 0;
    for (std::size_t i = 0; i < branches_.size(); ++i) {
      const double* of = memory + i * depth_.size();
      sum += branches_[i].share * (share > 0 ? of[j] + share * (of[j + 1] - of[j]) : of[j]);
    }
    return sum;
  }
  std::function<double(double)> lasting_;
  std::vector<Branch> branches_;
  std::vector<double> depth_;
  double sudden_ = 1;
};

struct Maker {
  const ImpactCase& impact;
  Outline nose;
  double deepest;
  int fineness;

  [[nodiscard]] std::unique_ptr<PadModel> operator()(const Elastic& law) {
    return std::make_unique<ElasticPad>(std::move(nose), impact.pad.thickness, fineness, law.modulus);
  }
  [[nodiscard]] std::unique_ptr<PadModel> operator()(const LinearViscoelastic& law) {
    return std::make_unique<MaxwellPad>(
        std::move(nose), impact.pad.thickness, fineness,
        [e = law.asymptotic_modulus](double x) { return e * x; },
        std::vector<MaxwellPad::Branch>{
            {law.initial_modulus / law.asymptotic_modulus - 1, law.relaxation_time}},
        deepest);
  }
  [[nodiscard]] std::unique_ptr<PadModel> operator()(const RigidFoam& law) {
    return std::make_unique<RigidFoamPad>(std::move(nose), impact.pad.thickness, fineness, law,
                                          impact.pad.earlier_penetration);
  }
  [[nodiscard]] std::unique_ptr<PadModel> operator()(const Foam& law) { return foam(law); }
  [[nodiscard]] std::unique_ptr<PadModel> operator()(const CrushableFoam& law) { return foam(law); }
  [[nodiscard]] std::unique_ptr<PadModel> operator()(const ViscoelasticFoam& law) {
    const MaxwellFormulas formulas(law);
    std::vector<MaxwellPad::Branch> branches;
    for (std::size_t i = 0; i < MaxwellFormulas::branches; ++i)
      if (formulas.share[i] > 0) branches.push_back({formulas.share[i], formulas.time[i]});
    return std::make_unique<MaxwellPad>(
        std::move(nose), impact.pad.thickness, fineness, [formulas](double e) { return formulas.lasting(e); },
        std::move(branches), deepest);
  }
  template <class Law>
  [[nodiscard]] std::unique_ptr<PadModel> operator()(const Law& law) {
    return law_pad(law, std::move(nose), impact.pad.thickness, fineness, deepest);
  }
  template <class Law>
  [[nodiscard]] std::unique_ptr<PadModel> foam(const Law& law) {
    return std::make_unique<FoamPad>(std::move(nose), impact.pad.thickness, fineness, law,
                                     impact.pad.earlier_penetration);
  }
};

}  // namespace

std::unique_ptr<PadModel> pad_model(const ImpactCase& impact, double deepest, int fineness) {
  const Pad& pad = impact.pad;
  Outline nose = outline_of(impact.impactor.nose, pad.area);
  if (!pad.layers.empty()) return layer_pad(pad, std::move(nose), fineness, deepest);
  return std::visit(Maker{impact, std::move(nose), deepest, fineness},
                    scaled(pad.material.law, stress_factor(pad.condition, pad.material)));
}

}  // namespace dashpad::oracle
