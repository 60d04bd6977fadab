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

/// What the strain alone determines about each column, the numbers of the strain part and A, as series in a
/// change of the strain; their values are in the Columns that were computed with them.
struct StrainSeries {
  std::array<double*, Columns::max_parts> part_first{};
  std::array<double*, Columns::max_parts> part_second{};
  double* shape_first = nullptr;
  double* shape_second = nullptr;
};

/// Weights a'(s) / (2 pi) of the cell between a column and the next, m: at the column and at the next.
struct CellWeights {
  const double* inner = nullptr;
  const double* outer = nullptr;
};

/// Depths, weights, states and series, allocated once, with spare room for one vector behind the last column.
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
    for (Columns* columns : {&now, &tried, &moved})
      *columns = {take(), {take(), take(), take()}, take(), take(), take()};
    series = {{take(), take(), take()}, {take(), take(), take()}, take(), take()};
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
  Columns tried;        ///< after a step of which all columns were computed
  StrainSeries series;  ///< about the strains of that
  Columns moved;        ///< after a step to strains near those, computed from the series

 private:
  static constexpr std::size_t spare = 64;  ///< lanes of the widest known vector
  static constexpr std::size_t arrays = 3 + 3 * 7 + 8;
  static constexpr std::size_t stride = max_stations + spare;

  std::unique_ptr<double[]> memory_ = std::make_unique_for_overwrite<double[]>(arrays * stride);
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
  double before = 0;      ///< penetration before the step
  double after = 0;       ///< penetration after the step
  double largest = 0;     ///< largest penetration so far
  std::size_t first = 0;  ///< the first column to be computed
};

/// A step whose penetration ends near that of a step whose columns were computed with their series.
struct MovedStep {
  double further = 0;   ///< change of the strain from there
  double max_bend = 0;  ///< largest second-order term of a series up to which it is used, in its value
};

/// Largest second-order term of a series in the strain up to which it is used, as a share of its value: the
/// error, of third order in the change, is then of order 4.5 in the resolution rho. (With three times that,
/// the figures of laws 4 and 5 moved by less than 1e-4 of their estimates, with thirty times by 1.6 %.)
inline double max_bend_of_series(double resolution) { return 0.03 * resolution * resolution * resolution; }

/// The functions of one law.
template <class Law>
struct SweepOf {
  using RatePart = typename Law::RatePart;
  using TimePart = typename Law::TimePart;
  /// Fills `next` with the state after the step from `now`, and the series where there is room for them.
  void (*step)(const Law&, const PowerShape&, const RatePart&, const TimePart&, const SweepStep&,
               const Columns& now, const Columns& next, const StrainSeries*) = nullptr;
  /// The same from the series about the strains of `tried`. Returns the number of columns, from the axis on,
  /// up to the first of which a series does not suffice.
  std::size_t (*move)(const Law&, const PowerShape&, const RatePart&, const TimePart&, const SweepStep&,
                      const Columns& now, const Columns& next, const MovedStep&, const Columns& tried,
                      const StrainSeries&) = nullptr;
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
