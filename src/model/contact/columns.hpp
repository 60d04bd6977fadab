#pragma once
/// The columns of a contact, one array a quantity, so that several columns fit one vector register.

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>

#include "model/contact/station_layout.hpp"

namespace dashpad {

/// Where the state of the columns is; `part` is the law's strain part, number by number.
struct Columns {
  static constexpr std::size_t most_parts = 3;

  double* stress = nullptr;
  std::array<double*, most_parts> part{};
  double* shape = nullptr;    ///< A
  double* measure = nullptr;  ///< w
  double* ratio = nullptr;    ///< stress over A, Pa; of the columns under strain only

  [[nodiscard]] std::array<double*, 7> all() const {
    return {stress, part[0], part[1], part[2], shape, measure, ratio};
  }
};

/// By what the cell between a column and the next counts, a'(s) / (2 pi) in m: at the column, and at the
/// next.
struct CellWeights {
  const double* inner = nullptr;
  const double* outer = nullptr;
};

/// Depths, weights and two states, in memory taken once. Behind the last column there is room for a vector's
/// worth of columns that are computed and thrown away.
class ColumnStorage {
 public:
  ColumnStorage() {
    double* next = memory_.get();
    const auto take = [&next] {
      double* array = next;
      next += stride;
      return array;
    };
    depth_ = take();
    inner_ = take();
    outer_ = take();
    for (Columns* columns : {&now, &next_state})
      *columns = {take(), {take(), take(), take()}, take(), take(), take()};
  }

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] const double* depth() const { return depth_; }
  /// The last column has no cell.
  [[nodiscard]] CellWeights weights() const { return {inner_, outer_}; }
  void set_weights(std::size_t cell, double inner, double outer) {
    inner_[cell] = inner;
    outer_[cell] = outer;
  }
  void clear() { size_ = 0; }

  /// A column at rest behind the others; after the last of several fill_spare() is due.
  void append(double depth) {
    depth_[size_] = depth;
    set_weights(size_, 0, 0);
    for (double* array : now.all()) array[size_] = 0;
    ++size_;
  }
  void fill_spare() {
    std::fill_n(depth_ + size_, spare, depth_[size_ - 1]);
    for (double* array : {inner_, outer_}) std::fill_n(array + size_, spare, 0.0);
    for (double* array : now.all()) std::fill_n(array + size_, spare, 0.0);
  }
  /// Moves the columns from `at` on outwards by one; their state `now` goes along. The new column is at rest;
  /// the weights of its cell and of that before it are to be set.
  void insert(std::size_t at, double depth) {
    const auto make_room = [&](double* array, double value) {
      std::copy_backward(array + at, array + size_, array + size_ + 1);
      array[at] = value;
    };
    make_room(depth_, depth);
    for (double* array : {inner_, outer_}) make_room(array, 0);
    for (double* array : now.all()) make_room(array, 0);
    ++size_;
    fill_spare();
  }

  Columns now;
  Columns next_state;

 private:
  static constexpr std::size_t spare = 64;  ///< lanes of the widest vector that is known
  static constexpr std::size_t stride = most_stations + spare;

  std::unique_ptr<double[]> memory_ = std::make_unique_for_overwrite<double[]>(17 * stride);
  double* depth_ = nullptr;  ///< s, increasing
  double* inner_ = nullptr;
  double* outer_ = nullptr;
  std::size_t size_ = 0;
};

}  // namespace dashpad
