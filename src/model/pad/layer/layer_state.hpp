#pragma once
/// What one layer of a pad remembers at one column, and the step that it is told to take.
///
/// Strains are engineering strains of the layer, compression positive; times in s.

namespace dashpad {

struct LayerState {
  double strain = 0;   ///< now; below 0 where the nose does not reach the column
  double largest = 0;  ///< so far, >= 0
  double rate = 0;     ///< mean over the last step, 1/s
  double memory = 0;   ///< of the law: foams: exp(-|g| / c) with the sign of g (theory.md, Eq. 34); law 2: Pa
};

struct LayerStep {
  double time = 0;       ///< its length, > 0
  double last_time = 0;  ///< of the step before; 0: there was none
};

/// A layer whose strain is held, or hardly changes (theory.md, Eq. 54).
struct LayerTangent {
  double relaxing = 0;   ///< change of the stress with time while the strain is held, Pa/s
  double loading = 0;    ///< change of the stress with a sudden strain, Pa, > 0
  double unloading = 0;  ///< the same backwards
};

}  // namespace dashpad
