#pragma once
/// A nose on a pad of the 9-parameter law: a closed form while the pad is only loaded (loading_force.hpp), a
/// field of columns from the first unloading on (column_field.hpp).

#include <cmath>
#include <cstddef>

#include "dashpad/quantities/constants.hpp"
#include "model/contact/column_field.hpp"
#include "model/contact/loading_force.hpp"

namespace dashpad {

class NineParameterContact {
 public:
  /// Allocates all memory; later calls do not.
  NineParameterContact(const NineParameter& law, double thickness, const Sections& nose)
      : law_(law),
        shape_(law.exponents(), thickness, nose),
        thickness_(thickness),
        nose_(nose),
        field_(law, thickness, nose) {}

  /// Changes to another pad in the same memory.
  void set(const NineParameter& law, double thickness, const Sections& nose) {
    law_ = law;
    shape_.set(law.exponents(), thickness, nose);
    thickness_ = thickness;
    nose_ = nose;
    field_.set(law, thickness, nose, ColumnMath::vector);
  }

  [[nodiscard]] bool recovers() const { return true; }
  [[nodiscard]] double first_force() const { return 0; }
  [[nodiscard]] double lock_penetration() const { return field_.lock_penetration(); }
  [[nodiscard]] std::size_t stations() const { return was_unloaded_ ? field_.stations() : 0; }
  [[nodiscard]] std::size_t updates() const { return updates_ + field_.updates(); }

  void start(double resolution, double = infinite) {
    penetration_ = 0;
    updates_ = 0;
    last_ = {};
    was_unloaded_ = has_columns_ = false;
    loading_.start();
    field_.clear(resolution);
    resolution_ = resolution;
    series_ = 0;
  }

  PadTrial trial(double advance, double from, double step) {
    if (!is_closed_form(advance)) return field().trial(advance, from, step);
    const PadTrial next{advance, from, step, 0};
    if (!next.shares_time_with(last_)) time_part_ = law_.time_part(from, from + step);
    ++updates_;
    const double end = penetration_ + advance;
    trial_ = loading_.trial(shape_force(end), law_, end, law_.rate_part(advance / (thickness_ * step)),
                            time_part_);
    return last_ = {advance, from, step, trial_.force};
  }
  [[nodiscard]] double force_rate_when_held(const PadTrial& trial) {
    if (!is_closed_form(trial.advance)) return field().force_rate_when_held(trial);
    recall(trial);
    return trial_.force_rate_when_held;
  }
  [[nodiscard]] double largest_stress(const PadTrial& trial) {
    // On loading nothing is in tension.
    return is_closed_form(trial.advance) ? 1 : field().largest_stress(trial);
  }
  void accept(const PadTrial& trial) {
    if (is_closed_form(trial.advance)) {
      recall(trial);
      loading_.accept(trial_);
      penetration_ = trial_.step.penetration;
      has_columns_ = false;
    } else {
      field().accept(trial);
      was_unloaded_ = true;
    }
    last_ = {};
  }

  [[nodiscard]] bool forgets(const PadTrial& trial) const { return field_.forgets(trial); }
  [[nodiscard]] double contact_radius() const {
    if (was_unloaded_) return field_.contact_radius();
    return nose_.radius(penetration_);
  }

 private:
  [[nodiscard]] bool is_closed_form(double advance) const { return !was_unloaded_ && advance >= 0; }
  /// K at a penetration: by its series about the last one for which it was computed, if that is near.
  [[nodiscard]] double shape_force(double penetration) {
    double further = penetration - series_at_;
    const double bend = std::abs(series_.second) * further * further;
    if (!(bend < max_bend_of_series(resolution_) * series_.value &&
          shape_.is_smooth_between(penetration, series_at_))) {
      series_ = shape_.around(penetration);
      series_at_ = penetration;
      further = 0;
    }
    return series_.value + further * (series_.first + further * series_.second);
  }
  void recall(const PadTrial& wanted) {
    if (!last_.is_same_step_as(wanted)) trial(wanted.advance, wanted.from, wanted.step);
  }
  /// The columns in the accepted state.
  ColumnField<NineParameter>& field() {
    if (!was_unloaded_ && !has_columns_) {
      field_.begin_after(loading_.steps(), loading_.force());
      has_columns_ = true;
    }
    return field_;
  }

  NineParameter law_;
  ContactShape shape_;
  double thickness_;
  Sections nose_;
  double penetration_ = 0;
  bool was_unloaded_ = false;
  bool has_columns_ = false;  ///< columns are laid for the accepted state
  std::size_t updates_ = 0;
  NineParameter::TimePart time_part_{};  ///< time part of the last trial
  PadTrial last_;                        ///< step 0: no trial from the accepted state
  LoadingTrial trial_;
  double resolution_ = 0;
  ContactShape::Series series_ = 0;  ///< K, about the penetration series_at_, m
  double series_at_ = 0;
  LoadingForce loading_;
  ColumnField<NineParameter> field_;
};

}  // namespace dashpad
