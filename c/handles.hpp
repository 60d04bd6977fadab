#pragma once
/// What the handles of include/dashpad.h stand for, and how failures leave its functions: no exception does.

#include <memory>
#include <new>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "dashpad.h"
#include "dashpad/case/case_quantity.hpp"
#include "dashpad/impact/solve.hpp"
#include "dashpad/input/case_file.hpp"
#include "dashpad/input/fault.hpp"
#include "dashpad/quantities/constants.hpp"

struct dashpad_faults {
  std::vector<dashpad::input::Fault> all;
  std::vector<std::string> lines;
  std::string text;
};

struct dashpad_case {
  std::string text, file, materials;
  bool is_file = false;               ///< the text is that of the file
  std::vector<std::string> settings;  ///< "KEY=VALUE", in the order in which they were made
  dashpad::input::CaseFile read;
  std::shared_ptr<const dashpad::CaseQuantities> quantities;  ///< of `read`; copies of a case share them
  std::string toml;
};

struct dashpad_solver {
  dashpad::Solver solver;
};

struct dashpad_result {
  dashpad::ImpactCase impact;
  dashpad::Solution solution;
  std::string status;
  std::optional<std::vector<double>> figures;  ///< in the order of response_kinds(); once one was asked for
  std::optional<std::vector<std::string>> flags;
  std::string json;
};

namespace dashpad::c {

inline std::string text_of(const char* text) { return text == nullptr ? "" : text; }
/// Puts the faults where the caller asked for them.
void tell(dashpad_faults** faults, std::vector<input::Fault> all);
/// A fault of no file.
input::Fault fault_of(std::string key, std::string rule);

/// The result of `make`, or that of a failure, after which `faults` say why.
template <class Make>
auto guarded(dashpad_faults** faults, Make&& make) noexcept -> decltype(make()) {
  if (faults != nullptr) *faults = nullptr;
  try {
    try {
      return make();
    } catch (const input::InputError& error) {
      tell(faults, error.faults());
    } catch (const std::bad_alloc&) {
      tell(faults, {fault_of("", "there is not enough memory")});
    } catch (const std::exception& error) {
      tell(faults, {fault_of("", error.what())});
    }
  } catch (...) {
    // Not even memory for a fault: the result says that there is none.
  }
  return {};
}

/// What a handle stands for. NULL is a mistake of the caller, and told as a fault.
template <class Handle>
Handle& of(Handle* handle) {
  if (handle == nullptr) throw std::invalid_argument("a handle is NULL");
  return *handle;
}

/// The value that `find` finds, or NaN.
template <class Find>
double value_of(Find&& find) noexcept {
  try {
    return find();
  } catch (...) {
    return no_value;
  }
}

}  // namespace dashpad::c
