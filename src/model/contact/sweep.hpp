#pragma once
/// One step of all columns under strain: strain, envelope, stress (theory.md, Eq. 9) and
/// stress over A (Eq. 20).
///
/// By vectors of columns, for the instruction set of the processor that the program runs on, or one by one in
/// doubles: one text (model/contact/sweep_columns.hpp), two number types.

#include <cstddef>
#include <tuple>

#include "dashpad/model/pad/law.hpp"
#include "model/contact/columns.hpp"
#include "model/contact/loading_force.hpp"

namespace dashpad {

/// How columns are computed: by vectors, or one by one.
enum class ColumnMath { vector, plain };

/// What is the same for all columns of a step. Lengths in m.
struct SweepStep {
  const double* depth = nullptr;
  std::size_t count = 0;  ///< columns under strain after the step, > 0
  double thickness = 0;
  double before = 0;   ///< penetration before the step
  double after = 0;    ///< and after it
  double largest = 0;  ///< largest penetration so far
};

/// The functions of one law.
template <class Law>
struct SweepOf {
  /// Fills `next` from `now`.
  void (*step)(const Law&, const PowerShape&, const typename Law::RatePart&, const typename Law::TimePart&,
               const SweepStep&, const Columns& now, const Columns& next) = nullptr;
  /// Integral over w, from column to column, all of the step's count, of the rate at which held columns relax
  /// at a time: h (G - stress) / A a'/(2 pi) where they press, else 0, with G at rate zero. The last column's
  /// value without a' is left in `edge`.
  double (*sum_of_held)(const Law&, const PowerShape&, double time, const SweepStep&, const CellWeights&,
                        const Columns&, double& edge) = nullptr;
};

struct Sweeps {
  WithMemory<SweepOf> of_laws;
  /// The state of the columns after a loading of the 9-parameter law that is known step by step, from rest.
  void (*replay)(const PowerShape&, const LoadingStep* first, const LoadingStep* last, const SweepStep&,
                 const Columns&) = nullptr;
  /// Sum of the positive parts of the first cells between neighbouring columns, in which g is linear in w.
  double (*sum_of_cells)(const Columns&, const CellWeights&, std::size_t cells) = nullptr;

  template <class Law>
  [[nodiscard]] const SweepOf<Law>& of() const {
    return std::get<SweepOf<Law>>(of_laws);
  }
};

const Sweeps& sweeps(ColumnMath math);

}  // namespace dashpad
