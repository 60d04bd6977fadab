#pragma once
// A value for each thread of a loop, made when it is first asked for.

#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "tbb/parallel_for.h"

namespace tbb {

template <class Value>
class enumerable_thread_specific {
 public:
  enumerable_thread_specific() : make_([] { return std::make_unique<Value>(); }) {}
  template <class Make>
  explicit enumerable_thread_specific(Make make)
      : make_([make = std::move(make)] { return std::make_unique<Value>(make()); }) {}

  Value& local() {
    std::unique_ptr<Value>& value = values_[worker_number];
    if (!value) value = make_();
    return *value;
  }

 private:
  std::function<std::unique_ptr<Value>()> make_;
  std::vector<std::unique_ptr<Value>> values_ = std::vector<std::unique_ptr<Value>>(worker_count());
};

}  // namespace tbb
