#pragma once
// WebAssembly has one thread: the value of TBB's only thread.

#include <optional>

namespace tbb {

template <class Value>
class enumerable_thread_specific {
 public:
  Value& local() {
    if (!value_) value_.emplace();
    return *value_;
  }

 private:
  std::optional<Value> value_;
};

}  // namespace tbb
