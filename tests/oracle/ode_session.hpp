#pragma once
/// A small C++ door to SUNDIALS CVODE: one system of equations, integrated until one of its events.

#include <memory>
#include <vector>

namespace dashpad::oracle {

/// What is integrated. All calls are for the same, fixed number of unknowns.
class OdeSystem {
 public:
  virtual ~OdeSystem() = default;
  /// Returns false where the state is not admissible: the integrator then tries a shorter step.
  virtual bool derivative(double time, const double* state, double* slope) = 0;
  /// Absolute error that each unknown may have in a step.
  virtual void allowances(const double* state, double* allowance) = 0;
  /// Functions whose sign changes are events.
  virtual void events(double time, const double* state, double* values) = 0;
  [[nodiscard]] virtual int event_count() const = 0;
};

enum class Method {
  bdf_dense,    ///< implicit, Newton with a dense difference-quotient Jacobian: stiff systems
  adams_fixed,  ///< Adams-Moulton with fixed-point iteration: systems that are not stiff
};

class OdeSession {
 public:
  struct Impl;
  OdeSession(OdeSystem& system, Method method, double time, const std::vector<double>& state);
  ~OdeSession();
  OdeSession(const OdeSession&) = delete;
  OdeSession& operator=(const OdeSession&) = delete;

  /// One internal step, or less up to an event; false when CVODE gives up.
  bool step();
  /// After step(): +1, -1 for an event function that crossed zero rising or falling, otherwise 0.
  [[nodiscard]] const std::vector<int>& crossings() const;
  [[nodiscard]] bool at_event() const;
  [[nodiscard]] double time() const;
  [[nodiscard]] double* state();
  /// Continues from the current time with a changed state or changed equations.
  void restart();
  [[nodiscard]] long derivative_calls() const;
  [[nodiscard]] long steps() const;

 private:
  std::unique_ptr<Impl> impl_;
};

}  // namespace dashpad::oracle
