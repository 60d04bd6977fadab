#include "mpi/ranks.hpp"

#include <bit>
#include <cstdlib>
#include <stdexcept>

// The C interface only; the C++ one is gone from MPI-3.
#define OMPI_SKIP_MPICXX 1
#define MPICH_SKIP_MPICXX 1
#include <mpi.h>

namespace dashpad::app {

namespace {

void add(Message& message, const std::vector<double>& values) {
  message.push_back(values.size());
  for (const double value : values) message.push_back(std::bit_cast<std::uint64_t>(value));
}

class Reader {
 public:
  explicit Reader(const Message& message) : message_(message) {}
  std::uint64_t next() {
    if (place_ == message_.size()) throw std::runtime_error("a rank sent a truncated batch");
    return message_[place_++];
  }
  double number() { return std::bit_cast<double>(next()); }
  std::vector<double> numbers() {
    const std::uint64_t count = next();
    std::vector<double> values;
    for (std::uint64_t i = 0; i < count; ++i) values.push_back(number());
    return values;
  }

 private:
  const Message& message_;
  std::size_t place_ = 0;
};

std::uint64_t reduced(std::uint64_t number, MPI_Op operation) {
  std::uint64_t result = 0;
  MPI_Allreduce(&number, &result, 1, MPI_UINT64_T, operation, MPI_COMM_WORLD);
  return result;
}

Letter read(const MPI_Status& waiting) {
  int count = 0;
  MPI_Get_count(&waiting, MPI_UINT64_T, &count);
  Letter letter{static_cast<Tag>(waiting.MPI_TAG), waiting.MPI_SOURCE,
                Message(static_cast<std::size_t>(count))};
  MPI_Recv(letter.numbers.data(), count, MPI_UINT64_T, waiting.MPI_SOURCE, waiting.MPI_TAG, MPI_COMM_WORLD,
           MPI_STATUS_IGNORE);
  return letter;
}

}  // namespace

Message packed(const BatchReport& report) {
  Message message{report.batch, report.stop_wanted ? 1U : 0U, report.rows.size()};
  for (const study::StoredRow& row : report.rows) {
    message.push_back(row.row);
    message.push_back(static_cast<std::uint64_t>(row.outcome.status));
    message.push_back(std::uint64_t{2} * row.outcome.extrapolated + (row.outcome.bottomed ? 1U : 0U));
    message.push_back(std::bit_cast<std::uint64_t>(row.outcome.error));
    add(message, row.factors);
    add(message, row.outcome.values);
  }
  return message;
}

BatchReport unpacked(const Message& message) {
  Reader reader{message};
  BatchReport report{.batch = reader.next(), .stop_wanted = reader.next() != 0, .rows = {}};
  const std::uint64_t count = reader.next();
  for (std::uint64_t i = 0; i < count; ++i) {
    study::StoredRow& row = report.rows.emplace_back();
    row.row = reader.next();
    row.outcome.status = static_cast<Status>(reader.next());
    const std::uint64_t flags = reader.next();
    row.outcome.extrapolated = static_cast<unsigned>(flags / 2);
    row.outcome.bottomed = flags % 2 != 0;
    row.outcome.error = reader.number();
    row.factors = reader.numbers();
    row.outcome.values = reader.numbers();
  }
  return report;
}

Ranks::Ranks() {
  int provided = 0;
  MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &provided);
  MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
  MPI_Comm_size(MPI_COMM_WORLD, &size_);
}

Ranks::~Ranks() { MPI_Finalize(); }

std::optional<int> Ranks::first_with(bool errors) const {
  const auto none = static_cast<std::uint64_t>(size_);
  const std::uint64_t first = reduced(errors ? static_cast<std::uint64_t>(rank_) : none, MPI_MIN);
  return first == none ? std::nullopt : std::optional{static_cast<int>(first)};
}

bool Ranks::is_same_for_all(std::uint64_t number) const {
  return reduced(number, MPI_MIN) == reduced(number, MPI_MAX);
}

std::uint64_t Ranks::of_first(std::uint64_t number) const {
  MPI_Bcast(&number, 1, MPI_UINT64_T, 0, MPI_COMM_WORLD);
  return number;
}

void Ranks::send(int to, Tag tag, const Message& numbers) {
  MPI_Send(numbers.data(), static_cast<int>(numbers.size()), MPI_UINT64_T, to, static_cast<int>(tag),
           MPI_COMM_WORLD);
}

Letter Ranks::receive(int from) {
  MPI_Status waiting;
  MPI_Probe(from, MPI_ANY_TAG, MPI_COMM_WORLD, &waiting);
  return read(waiting);
}

std::optional<Letter> Ranks::next_letter() {
  int is_there = 0;
  MPI_Status waiting;
  MPI_Iprobe(MPI_ANY_SOURCE, MPI_ANY_TAG, MPI_COMM_WORLD, &is_there, &waiting);
  if (is_there == 0) return std::nullopt;
  return read(waiting);
}

void Ranks::abort(int exit_code) {
  MPI_Abort(MPI_COMM_WORLD, exit_code);
  std::abort();
}

}  // namespace dashpad::app
