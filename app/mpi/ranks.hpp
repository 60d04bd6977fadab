#pragma once
/// The ranks of an MPI job, and what they say to each other: the rows of a batch as numbers, bit for bit.
/// Only built where there is an MPI.

#include <cstdint>
#include <optional>
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

/// What a rank says to rank 0, and what that answers.
enum class Tag { ready = 1, result, failure, batch, stop };

struct Letter {
  Tag tag = Tag::ready;
  int rank = 0;  ///< from whom
  Message numbers;
};

/// MPI from here to the end of this object's life. One in a program; used from one thread.
class Ranks {
 public:
  Ranks();
  ~Ranks();
  Ranks(const Ranks&) = delete;
  Ranks& operator=(const Ranks&) = delete;

  [[nodiscard]] int rank() const { return rank_; }
  [[nodiscard]] int size() const { return size_; }
  [[nodiscard]] bool is_first() const { return rank_ == 0; }

  /// Called by all: the first rank for which something is wrong.
  [[nodiscard]] std::optional<int> first_with(bool errors) const;
  /// Called by all: whether all have the same number.
  [[nodiscard]] bool is_same_for_all(std::uint64_t number) const;
  /// Called by all: the number of rank 0.
  [[nodiscard]] std::uint64_t of_first(std::uint64_t number) const;

  static void send(int to, Tag tag, const Message& numbers);
  /// Waits for it.
  static Letter receive(int from);
  /// A letter from anyone, if one is there.
  static std::optional<Letter> next_letter();

  /// Ends all ranks at once.
  [[noreturn]] static void abort(int exit_code);

 private:
  int rank_ = 0, size_ = 1;
};

}  // namespace dashpad::app
