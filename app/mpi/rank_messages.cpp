#include "mpi/rank_messages.hpp"

#include <bit>
#include <stdexcept>

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
    if (place_ == message_.size()) throw std::runtime_error("a rank sent a batch that ends too early");
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

}  // namespace dashpad::app
