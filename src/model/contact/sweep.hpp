#pragma once
/// One step of all columns under strain: strain, envelope, stress (theory.md, Eq. 9), stress over A (Eq. 20).
///
/// Columns are computed in vectors for the instruction set of the processor, or one by one in doubles, from
/// one text (model/contact/sweep_columns.hpp) for both number types.

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <tuple>

#include "dashpad/model/pad/law.hpp"
#include "model/contact/loading_force.hpp"
#include "model/contact/station_layout.hpp"

namespace dashpad {

// The columns of a contact: one array for each quantity, so that several columns fit one vector register.

/// State of the columns; `part` holds the numbers of the law's strain part.
struct Columns {
  static constexpr std::size_t max_parts = 3;

  double* stress = nullptr;
  std::array<double*, max_parts> part{};
  double* shape = nullptr;    ///< A
  double* measure = nullptr;  ///< w
  double* ratio = nullptr;    ///< stress over A, Pa; only for columns under strain

  [[nodiscard]] std::array<double*, 7> all() const {
    return {stress, part[0], part[1], part[2], shape, measure, ratio};
  }
};

/// Weights a'(s) / (2 pi) of the cell between a column and the next, m: at the column and at the next.
struct CellWeights {
  const double* inner = nullptr;
  const double* outer = nullptr;
};

/// Depths, weights and two states, allocated once, with spare room for one vector behind the last column.
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
  /// Weights of the cells; the last column has none.
  [[nodiscard]] CellWeights weights() const { return {inner_, outer_}; }
  void set_weights(std::size_t cell, double inner, double outer) {
    inner_[cell] = inner;
    outer_[cell] = outer;
  }
  void clear() { size_ = 0; }

  /// Appends a column at rest; fill_spare() must follow after the last one.
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
  /// Inserts a column at rest at the index `at`, and moves the others with their state `now` outwards. The
  /// caller sets the weights of its cell and of the cell before it.
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
  static constexpr std::size_t spare = 64;  ///< lanes of the widest known vector
  static constexpr std::size_t stride = max_stations + spare;

  std::unique_ptr<double[]> memory_ = std::make_unique_for_overwrite<double[]>(17 * stride);
  double* depth_ = nullptr;  ///< s, increasing
  double* inner_ = nullptr;
  double* outer_ = nullptr;
  std::size_t size_ = 0;
};

/// Computation of columns: in vectors, or one by one.
enum class ColumnMath { vector, plain };

/// Data common to all columns of a step. Lengths in m.
struct SweepStep {
  const double* depth = nullptr;
  std::size_t count = 0;  ///< columns under strain after the step, > 0
  double thickness = 0;
  double before = 0;   ///< penetration before the step
  double after = 0;    ///< penetration after the step
  double largest = 0;  ///< largest penetration so far
};

/// The functions of one law.
template <class Law>
struct SweepOf {
  /// Fills `next` with the state after the step from `now`.
  void (*step)(const Law&, const PowerShape&, const typename Law::RatePart&, const typename Law::TimePart&,
               const SweepStep&, const Columns& now, const Columns& next) = nullptr;
  /// Integral over w of h (G - stress) / A a'/(2 pi) of the held columns, where they press, with G at rate
  /// zero. Sets `edge` to the last column's value without a'/(2 pi).
  double (*sum_of_held)(const Law&, const PowerShape&, double time, const SweepStep&, const CellWeights&,
                        const Columns&, double& edge) = nullptr;
};

struct Sweeps {
  WithMemory<SweepOf> of_laws;
  /// Computes the state of the columns after a loading of the 9-parameter law from rest, given step by step.
  void (*replay)(const PowerShape&, const LoadingStep* first, const LoadingStep* last, const SweepStep&,
                 const Columns&) = nullptr;
  /// Sum over the first `cells` cells of the integral of max(g, 0), with g linear in w.
  double (*sum_of_cells)(const Columns&, const CellWeights&, std::size_t cells) = nullptr;

  template <class Law>
  [[nodiscard]] const SweepOf<Law>& of() const {
    return std::get<SweepOf<Law>>(of_laws);
  }
};

const Sweeps& sweeps(ColumnMath math);

}  // namespace dashpad
