#pragma once
/// The ranks of an MPI job and their messages, bit for bit. Only built with an MPI.

#include <cstdint>
#include <optional>
#include <vector>

#include "dashpad/study/store.hpp"

namespace dashpad::app {

using Message = std::vector<std::uint64_t>;

struct BatchReport {
  std::uint64_t batch = 0;
  bool stop_wanted = false;  ///< this rank was told to stop
  std::vector<study::StoredRow> rows;
};

Message packed(const BatchReport& report);
/// Throws std::runtime_error for an invalid message.
BatchReport unpacked(const Message& message);

/// Messages from a rank to rank 0, and its answers.
enum class Tag { ready = 1, result, failure, batch, stop };

struct Letter {
  Tag tag = Tag::ready;
  int rank = 0;  ///< from whom
  Message numbers;
};

/// MPI during the life of this object. One per program, used from one thread.
class Ranks {
 public:
  Ranks();
  ~Ranks();
  Ranks(const Ranks&) = delete;
  Ranks& operator=(const Ranks&) = delete;

  [[nodiscard]] int rank() const { return rank_; }
  [[nodiscard]] int size() const { return size_; }
  [[nodiscard]] bool is_first() const { return rank_ == 0; }

  /// Called by all: the first rank with errors.
  [[nodiscard]] std::optional<int> first_with(bool errors) const;
  /// Called by all: whether all have the same number.
  [[nodiscard]] bool is_same_for_all(std::uint64_t number) const;
  /// Called by all: the number of rank 0.
  [[nodiscard]] std::uint64_t of_first(std::uint64_t number) const;

  static void send(int to, Tag tag, const Message& numbers);
  /// Waits for a letter.
  static Letter receive(int from);
  /// A letter from anyone, if there is one.
  static std::optional<Letter> next_letter();

  /// Ends all ranks at once.
  [[noreturn]] static void abort(int exit_code);

 private:
  int rank_ = 0, size_ = 1;
};

}  // namespace dashpad::app
