#pragma once
/// The contact in SPIT: its stations, their strains, and the force.

#include "dashpad/spit1984/run.hpp"
#include "spit1984/pad.hpp"

namespace dashpad::spit1984 {

/// Numbers in comments are the statement numbers of the listing.
template <class Real>
class Contact {
 public:
  Contact(const Deck& deck, const Settings& settings)
      : law_(deck.pad),
        defects_(settings.defects),
        dimension_(settings.max_stations),
        radius_(static_cast<Real>(deck.radius_in)),
        thickness_(static_cast<Real>(deck.thickness_in)),
        station_spacing_(radius_ / Real(100)),
        parameters_(converted<Real>(deck.pad_parameters)),
        field_(static_cast<std::size_t>(settings.max_stations)) {}

  /// With the bookkeeping mended, remembers the contact to which every trial of the step returns.
  void start_step() {
    if (defects_.stale_contact) return;
    stations_before_ = stations_;
    edge_before_ = edge_;
  }

  /// F(K) of a trial: the force with the axis penetrated to `penetration` at the end of a step of `step`, at
  /// `time`; negative in compression. Absent when the contact field is full.
  std::optional<Real> force(Real penetration, Real step, Real time) {
    if (!widen(penetration)) return std::nullopt;
    find_strains(penetration);
    residual_strain_ = update_stresses(law_, parameters_, field_, stations_, step, time);
    drop_tension();
    return static_cast<Real>(3.141593) * integral() / Real(2);  // PI of the listing
  }

  /// 235, 238: the contact before the rejected trial; with the defect, before the last one that widened it.
  void restore() {
    stations_ = stations_before_;
    edge_ = edge_before_;
  }

  /// 250: the strains and stresses of the trial become those of the step.
  void accept() {
    for (int i = 0; i < stations_; ++i) field_.accept(i);
  }

  /// TIME on return from PAD: the residual strain on the axis, projected by the last trial.
  [[nodiscard]] Real residual_strain() const { return residual_strain_; }
  /// That the field ever held.
  [[nodiscard]] int max_stations() const { return max_stations_; }

 private:
  /// 110 to 140: stations at equal distances up to the contact radius, and one on it unless another is close.
  bool widen(Real penetration) {
    trial_edge_ = square_root(Real(2) * radius_ * penetration - penetration * penetration);
    if (trial_edge_ <= edge_) return true;
    if (defects_.stale_contact) {
      edge_before_ = edge_;
      stations_before_ = stations_;
    }
    const int whole = truncated((trial_edge_ - edge_) / station_spacing_);
    for (int j = 0; j < whole; ++j)
      if (!add_station(outermost() + station_spacing_)) return false;
    const Real rest = (trial_edge_ - outermost()) / station_spacing_;
    if (!(rest < static_cast<Real>(0.1)) && !add_station(trial_edge_)) return false;
    edge_ = trial_edge_;
    return true;
  }

  bool add_station(Real radius) {
    if (stations_ == dimension_) return false;
    field_.radius[stations_++] = radius;
    if (stations_ > max_stations_) max_stations_ = stations_;
    return true;
  }

  /// R(MAXR). Where no station is left, the listing reads R(0), outside the vector; here the axis.
  [[nodiscard]] Real outermost() const { return stations_ > 0 ? field_.radius[stations_ - 1] : Real(0); }

  /// 150.
  void find_strains(Real penetration) {
    for (int i = 0; i < stations_; ++i) {
      const Real ratio = field_.radius[i] / radius_;
      const Real depth = radius_ * (Real(1) - square_root(Real(1) - ratio * ratio));
      field_.new_strain[i] = (depth - penetration) / thickness_;
    }
    if (!defects_.edge_residue && stations_ > 1 && outermost() == trial_edge_)
      field_.new_strain[stations_ - 1] = Real(0);
  }

  /// 170: tensile stresses at the edge become zero and their stations leave. Laws 4 and 5 set the stress of
  /// the outermost station to zero themselves, so for them this never finds any.
  void drop_tension() {
    if (!defects_.tension)
      for (int i = 0; i < stations_; ++i)
        if (field_.new_stress[i] > Real(0)) field_.new_stress[i] = Real(0);
    while (stations_ > 0 && field_.new_stress[stations_ - 1] > Real(0))
      field_.new_stress[--stations_] = Real(0);
  }

  /// 181 to 210: twice the integral of stress over r dr, by the trapezoidal rule over rings (Eq. 17).
  [[nodiscard]] Real integral() const {
    if (stations_ == 1) return field_.new_stress[0] * (field_.radius[1] * field_.radius[1]);
    Real sum(0);
    for (int i = 1; i < stations_; ++i)
      sum = sum + (field_.new_stress[i] + field_.new_stress[i - 1]) *
                      (field_.radius[i] * field_.radius[i] - field_.radius[i - 1] * field_.radius[i - 1]);
    return sum;
  }

  const PadKey law_;
  const Defects defects_;
  const int dimension_;
  const Real radius_, thickness_;
  const Real station_spacing_;  ///< DR
  const PadParameters<Real> parameters_;
  ContactField<Real> field_;
  int stations_ = 1;         ///< MAXR
  Real edge_{};              ///< RLAST: the widest contact so far
  int stations_before_ = 0;  ///< LAST, what a rejected trial goes back to
  Real edge_before_{};       ///< RL
  Real trial_edge_{};        ///< RMAX
  Real residual_strain_{};
  int max_stations_ = 1;
};

}  // namespace dashpad::spit1984
