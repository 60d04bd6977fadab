#include "oracle/ode_session.hpp"

#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

#include <algorithm>
#include <stdexcept>

namespace dashpad::oracle {

struct OdeSession::Impl {
  OdeSystem* system = nullptr;
  SUNContext context = nullptr;
  void* memory = nullptr;
  N_Vector state = nullptr;
  SUNMatrix matrix = nullptr;
  SUNLinearSolver linear = nullptr;
  SUNNonlinearSolver nonlinear = nullptr;
  double time = 0;
  double farthest = 0;  ///< bound of the integration, only a direction for CVODE
  bool event = false;
  bool implicit = false;
  std::vector<int> crossings;
  long calls = 0;
  long steps = 0;  ///< before the last restart

  [[nodiscard]] long steps_since_restart() const {
    long count = 0;
    CVodeGetNumSteps(memory, &count);
    return count;
  }
  ~Impl() {
    if (memory != nullptr) CVodeFree(&memory);
    if (linear != nullptr) SUNLinSolFree(linear);
    if (nonlinear != nullptr) SUNNonlinSolFree(nonlinear);
    if (matrix != nullptr) SUNMatDestroy(matrix);
    if (state != nullptr) N_VDestroy(state);
    if (context != nullptr) SUNContext_Free(&context);
  }
};

namespace {

constexpr int max_fresh_starts = 3;  ///< for one step

void require(int flag) {
  if (flag < 0) throw std::runtime_error("CVODE could not be set up");
}

int derivative_door(realtype time, N_Vector state, N_Vector slope, void* data) {
  auto* impl = static_cast<OdeSession::Impl*>(data);
  ++impl->calls;
  return impl->system->derivative(time, N_VGetArrayPointer(state), N_VGetArrayPointer(slope)) ? 0 : 1;
}

int events_door(realtype time, N_Vector state, realtype* values, void* data) {
  static_cast<OdeSession::Impl*>(data)->system->events(time, N_VGetArrayPointer(state), values);
  return 0;
}

int weights_door(N_Vector state, N_Vector weights, void* data) {
  double* values = N_VGetArrayPointer(weights);
  static_cast<OdeSession::Impl*>(data)->system->allowances(N_VGetArrayPointer(state), values);
  const auto count = N_VGetLength(weights);
  for (sunindextype i = 0; i < count; ++i) values[i] = 1 / values[i];
  return 0;
}

void silent(int, const char*, const char*, char*, void*) {}

}  // namespace

OdeSession::OdeSession(OdeSystem& system, Method method, double time, const std::vector<double>& state)
    : impl_(std::make_unique<Impl>()) {
  Impl& m = *impl_;
  m.system = &system;
  m.time = time;
  m.farthest = time + 1e3;
  m.implicit = method == Method::bdf_dense;
  const auto count = static_cast<sunindextype>(state.size());
  require(SUNContext_Create(nullptr, &m.context));
  m.state = N_VNew_Serial(count, m.context);
  std::copy(state.begin(), state.end(), N_VGetArrayPointer(m.state));
  m.memory = CVodeCreate(m.implicit ? CV_BDF : CV_ADAMS, m.context);
  require(CVodeSetErrHandlerFn(m.memory, silent, nullptr));
  require(CVodeInit(m.memory, derivative_door, time, m.state));
  require(CVodeSetUserData(m.memory, &m));
  require(CVodeWFtolerances(m.memory, weights_door));
  if (m.implicit) {
    m.matrix = SUNDenseMatrix(count, count, m.context);
    m.linear = SUNLinSol_Dense(m.state, m.matrix, m.context);
    require(CVodeSetLinearSolver(m.memory, m.linear, m.matrix));
  } else {
    m.nonlinear = SUNNonlinSol_FixedPoint(m.state, 0, m.context);
    require(CVodeSetNonlinearSolver(m.memory, m.nonlinear));
  }
  m.crossings.assign(static_cast<std::size_t>(system.event_count()), 0);
  require(CVodeRootInit(m.memory, system.event_count(), events_door));
  require(CVodeSetNoInactiveRootWarn(m.memory));
}

OdeSession::~OdeSession() = default;

bool OdeSession::step() {
  int flag = CVode(impl_->memory, impl_->farthest, impl_->state, &impl_->time, CV_ONE_STEP);
  for (int k = 0; flag < 0 && k < max_fresh_starts; ++k) {
    // Its past can be of no use near a kink of the equations (a speed that dies out): start afresh from here.
    restart();
    flag = CVode(impl_->memory, impl_->farthest, impl_->state, &impl_->time, CV_ONE_STEP);
  }
  impl_->event = flag == CV_ROOT_RETURN;
  std::fill(impl_->crossings.begin(), impl_->crossings.end(), 0);
  if (impl_->event) CVodeGetRootInfo(impl_->memory, impl_->crossings.data());
  return flag >= 0;
}

const std::vector<int>& OdeSession::crossings() const { return impl_->crossings; }
bool OdeSession::at_event() const { return impl_->event; }
double OdeSession::time() const { return impl_->time; }
double* OdeSession::state() { return N_VGetArrayPointer(impl_->state); }
long OdeSession::derivative_calls() const { return impl_->calls; }
long OdeSession::steps() const { return impl_->steps + impl_->steps_since_restart(); }

void OdeSession::restart() {
  impl_->steps += impl_->steps_since_restart();
  require(CVodeReInit(impl_->memory, impl_->time, impl_->state));
}

}  // namespace dashpad::oracle
