#pragma once
/// The rows of a batch as numbers that travel between ranks, bit for bit.

#include <cstdint>
#include <vector>

#include "dashpad/study/store.hpp"

namespace dashpad::app {

using Message = std::vector<std::uint64_t>;

/// A batch and its rows.
struct BatchReport {
  std::uint64_t batch = 0;
  bool stop_wanted = false;  ///< this rank was told to stop
  std::vector<study::StoredRow> rows;
};

Message packed(const BatchReport& report);
/// Throws std::runtime_error for numbers that are no report.
BatchReport unpacked(const Message& message);

}  // namespace dashpad::app
