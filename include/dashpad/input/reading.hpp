#pragma once
/// What reading gives: a value, or every fault that stands in its way. Nothing is thrown for what a user
/// wrote.

#include <filesystem>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "dashpad/input/fault.hpp"

namespace dashpad::input {

/// A file that a result was computed from, so that it is not overwritten by that.
struct InputFile {
  std::string kind;  ///< with its article: "the case file", "the material card"
  std::filesystem::path file;
};

template <class T>
class [[nodiscard]] Reading {
 public:
  Reading(T value) : content_(std::in_place_index<0>, std::move(value)) {}
  /// One fault at least.
  Reading(std::vector<Fault> faults) : content_(std::in_place_index<1>, std::move(faults)) {}

  explicit operator bool() const { return content_.index() == 0; }
  /// None where there is a value.
  [[nodiscard]] std::vector<Fault> faults() const {
    const auto* const faults = std::get_if<1>(&content_);
    return faults ? *faults : std::vector<Fault>{};
  }

  /// Of a reading with a value.
  T& operator*() & { return *std::get_if<0>(&content_); }
  const T& operator*() const& { return *std::get_if<0>(&content_); }
  T&& operator*() && { return std::move(*std::get_if<0>(&content_)); }
  T* operator->() { return std::get_if<0>(&content_); }
  const T* operator->() const { return std::get_if<0>(&content_); }

  /// The value, for those who pass faults on as an exception: throws InputError.
  T value() && {
    if (!*this) throw InputError(faults());
    return *std::move(*this);
  }

 private:
  std::variant<T, std::vector<Fault>> content_;
};

/// For readers whose parts refuse by an exception: what `read` returns, or the faults of its InputError.
template <class Read>
auto reading_of(Read&& read) -> Reading<decltype(read())> {
  try {
    return read();
  } catch (const InputError& error) {
    return error.faults();
  }
}

}  // namespace dashpad::input
