#pragma once
/// A rigid nose pressed into a wide pad of hyperelastic foam, by axisymmetric finite elements. Columns are
/// independent of their neighbours; here the foam between them shears and stretches, so this tells by how
/// much the force of independent columns falls short.
///
/// Units are the caller's (kPa and thicknesses will do); stress, strain, depth and force positive in
/// compression.

#include <Eigen/Dense>
#include <Eigen/SparseCholesky>
#include <array>
#include <cstddef>
#include <vector>

namespace dashpad::oracle {

/// Foam with the energy, per volume at rest and with the principal stretches l and J = l1 l2 l3,
///   W = sum over terms of 2 mu/a^2 (l1^a + l2^a + l3^a - 3 + (J^(-a b) - 1)/b),   b = nu/(1 - 2 nu).
/// For nu -> 0 the last fraction tends to -a ln J, and W to a sum over the three stretches.
struct Hyperfoam {
  struct Term {
    double shear_modulus = 0;  ///< mu
    double exponent = 0;       ///< a, not 0
  };
  std::vector<Term> terms;
  double poisson_ratio = 0;  ///< nu, in [0, 1/2)

  /// E = 2 (1 + nu) sum of mu.
  [[nodiscard]] double young_modulus() const;
  /// Nominal stress of a column with free sides, whose lateral stretch is l^(-nu), l = 1 - strain:
  /// sum of 2 mu/a (l^(-1 - a nu) - l^(a - 1)).
  [[nodiscard]] double column_stress(double strain) const;
};

/// W with its first and second derivatives by the principal stretches.
struct StretchEnergy {
  double value = 0;
  Eigen::Vector3d slope = Eigen::Vector3d::Zero();
  Eigen::Matrix3d curvature = Eigen::Matrix3d::Zero();
};
StretchEnergy stretch_energy(const Hyperfoam& foam, const Eigen::Vector3d& l);

enum class RigidShape { sphere, flat_disc };
/// Foam below a rough face stays where it touched it, foam below a smooth one slips freely.
enum class Face { rough, smooth };
/// Foam stays everywhere on the floor; on a frictionless one it slips, but does not lift off.
enum class Floor { bonded, frictionless };

struct RigidNose {
  RigidShape shape = RigidShape::sphere;
  double radius = 0;
  Face face = Face::rough;
};

/// 0 to `end`: equal steps up to `even`, then steps that grow by about `ratio`. Both ends are among the
/// places.
std::vector<double> graded(double step, double even, double end, double ratio);

/// Total Lagrangian, quadrilaterals of four nodes with 2 x 2 points of Gauss, the deformation by Newton's
/// method on the energy. The nose is analytic. A surface node of area A that is p deep inside the nose adds
/// penalty * A p^2 / 2; the force is the slope of that energy by the depth of the nose.
/// A rough face holds to within one step of the nose: a node that is found on it after a step keeps its
/// radius from then on (the nose moves along the axis only), until it lets go; while it arrives, it slips.
/// Foam beside a disc does not meet its side.
class MeshedPad {
 public:
  /// Radii of the columns of nodes, and their depths below the surface, both from 0 on; the last are the
  /// pad's radius (its edge is free) and thickness. A disc's radius is one of the radii.
  MeshedPad(Hyperfoam foam, RigidNose nose, Floor floor, std::vector<double> radii,
            std::vector<double> depths);

  /// Takes the nose on to a depth in equal steps of at most `step`; gives the force. Throws
  /// std::runtime_error if no equilibrium is found.
  double press(double depth, double step);
  /// How much foam under a pressure gives way into the nose.
  [[nodiscard]] double give(double pressure) const { return pressure / penalty_; }

 private:
  using Vector = Eigen::VectorXd;
  /// A point of Gauss: the deformation gradient (rr, rz, zr, zz, hoop) is `gradient` times the node
  /// positions.
  struct Point {
    std::array<Eigen::Index, 8> unknowns;
    Eigen::Matrix<double, 5, 8> gradient;
    double volume = 0;
  };
  struct SurfaceNode {
    Eigen::Index radius = 0;  ///< which unknown; its height is the next
    double area = 0;          ///< what bears on it at rest
  };

  void add_element(std::size_t column, std::size_t row);
  [[nodiscard]] Eigen::Index radius_of(std::size_t column, std::size_t row) const {
    return static_cast<Eigen::Index>(2 * (column * depths_.size() + row));
  }
  [[nodiscard]] double inside_nose(const SurfaceNode& node, const Vector& x) const;
  [[nodiscard]] double energy(const Vector& x) const;
  /// Slope and stiffness of the energy; false if that is no minimum's. With `convex` the parts of the
  /// stiffness that may be negative count as none.
  bool factorize(bool convex);
  void settle();

  Hyperfoam foam_;
  RigidNose nose_;
  std::vector<double> radii_, depths_;
  double penalty_;
  double depth_ = 0;
  std::vector<Point> points_;
  std::vector<SurfaceNode> surface_;
  Eigen::ArrayX<bool> fixed_, stuck_;  ///< of each unknown
  Vector x_, slope_;                   ///< radius and height of each node; slope of the energy
  Eigen::SparseMatrix<double> stiffness_;
  std::vector<Eigen::Triplet<double>> entries_;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver_;
};

}  // namespace dashpad::oracle
