#pragma once
/// The integration stations of the contact: EK, EKP1, EMAX, SK, SKP1 and R of the listing.

#include <cstddef>
#include <vector>

namespace dashpad::spit1984 {

/// Station 0 is the axis. Strain and stress are negative in compression, as in the listing; the largest
/// strain is a magnitude.
template <class Real>
struct ContactField {
  std::vector<Real> radius;          ///< R, in
  std::vector<Real> strain;          ///< EK, at the start of the step
  std::vector<Real> new_strain;      ///< EKP1, at its end, of the trial at hand
  std::vector<Real> largest_strain;  ///< EMAX
  std::vector<Real> stress;          ///< SK, psi
  std::vector<Real> new_stress;      ///< SKP1, psi

  /// All zero, as the program's memory was. One more than the dimension: label 190 reads R(2) even of a
  /// contact of one station.
  explicit ContactField(std::size_t dimension)
      : radius(dimension + 1),
        strain(dimension + 1),
        new_strain(dimension + 1),
        largest_strain(dimension + 1),
        stress(dimension + 1),
        new_stress(dimension + 1) {}
};

}  // namespace dashpad::spit1984
