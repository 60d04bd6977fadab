#pragma once
/// The columns of a pad of layers, one array a quantity, in memory taken once.

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <vector>

#include "model/contact/station_layout.hpp"
#include "model/pad/layer/series.hpp"

namespace dashpad {

class LayerColumns {
 public:
  /// What a column is at one moment.
  struct Moment {
    double* stress = nullptr;       ///< Pa; below 0: free of stress
    double* y = nullptr;            ///< m
    double* flexibility = nullptr;  ///< dy/d(stress) over the step, m/Pa
    /// Of each layer.
    std::array<double*, most_layers> strain{}, largest{}, rate{}, memory{}, layer_flexibility{};
  };

  explicit LayerColumns(std::size_t layers) : layers_(layers) {
    memory_ = std::make_unique_for_overwrite<double[]>((6 + 2 * (3 + 5 * layers)) * most_stations);
    double* next = memory_.get();
    const auto take = [&next] {
      double* array = next;
      next += most_stations;
      return array;
    };
    for (double** array : {&depth_, &inner_, &outer_, &shape, &measure, &chord}) *array = take();
    for (Moment* moment : {&now, &next_moment}) {
      for (double** array : {&moment->stress, &moment->y, &moment->flexibility}) *array = take();
      for (auto* of :
           {&moment->strain, &moment->largest, &moment->rate, &moment->memory, &moment->layer_flexibility})
        for (std::size_t i = 0; i < layers; ++i) (*of)[i] = take();
    }
  }

  [[nodiscard]] std::size_t layers() const { return layers_; }
  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] const double* depth() const { return depth_; }
  /// By what the cell between a column and the next counts, a'(s) / (2 pi) in m: at the column, and at the
  /// next.
  [[nodiscard]] const double* inner_weight() const { return inner_; }
  [[nodiscard]] const double* outer_weight() const { return outer_; }

  void clear() { size_ = 0; }
  void append(double depth) { depth_[size_++] = depth; }
  void set_weights(std::size_t cell, double inner, double outer) {
    inner_[cell] = inner;
    outer_[cell] = outer;
  }

  Moment now;
  Moment next_moment;
  // Of the last trial.
  double* shape = nullptr;    ///< A, Pa
  double* measure = nullptr;  ///< w, Pa
  double* chord = nullptr;    ///< d(stress)/dy over the last step, Pa/m; the guess for the next

 private:
  std::size_t layers_;
  std::unique_ptr<double[]> memory_;
  double* depth_ = nullptr;
  double* inner_ = nullptr;
  double* outer_ = nullptr;
  std::size_t size_ = 0;
};

}  // namespace dashpad
