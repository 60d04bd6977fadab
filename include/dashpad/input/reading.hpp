#pragma once
/// The result of reading: a value, or all faults that prevent it. User errors are not thrown.

#include <filesystem>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "dashpad/input/fault.hpp"

namespace dashpad::input {

/// An input file of a result, which must not be overwritten.
struct InputFile {
  std::string kind;  ///< with its article: "the case file", "the material card"
  std::filesystem::path file;
};

template <class T>
class [[nodiscard]] Reading {
 public:
  Reading(T value) : content_(std::in_place_index<0>, std::move(value)) {}
  /// Takes at least one fault.
  Reading(std::vector<Fault> faults) : content_(std::in_place_index<1>, std::move(faults)) {}

  explicit operator bool() const { return content_.index() == 0; }
  /// Empty if there is a value.
  [[nodiscard]] std::vector<Fault> faults() const {
    const auto* const faults = std::get_if<1>(&content_);
    return faults ? *faults : std::vector<Fault>{};
  }

  /// Access to the value, which must exist.
  T& operator*() & { return *std::get_if<0>(&content_); }
  const T& operator*() const& { return *std::get_if<0>(&content_); }
  T&& operator*() && { return std::move(*std::get_if<0>(&content_)); }
  T* operator->() { return std::get_if<0>(&content_); }
  const T* operator->() const { return std::get_if<0>(&content_); }

  /// The value; throws InputError if there is none.
  T value() && {
    if (!*this) throw InputError(faults());
    return *std::move(*this);
  }

 private:
  std::variant<T, std::vector<Fault>> content_;
};

/// The result of `read`, or the faults of the InputError that it throws.
template <class Read>
auto reading_of(Read&& read) -> Reading<decltype(read())> {
  try {
    return read();
  } catch (const InputError& error) {
    return error.faults();
  }
}

}  // namespace dashpad::input
