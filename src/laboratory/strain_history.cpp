#include "dashpad/laboratory/column_test.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "laboratory/arc.hpp"

namespace dashpad::laboratory {
namespace {

/// Rounding of a strain that counts as none.
constexpr double rounding = 1e-9;

StrainPiece straight(double from, double to, double rate) {
  return {std::abs(to - from) / rate, from, to > from ? rate : -rate, 0};
}

void check_numbers(const StrainPiece& piece, const std::string& key, std::vector<Violation>& broken) {
  if (!(piece.duration > 0 && std::isfinite(piece.duration)))
    broken.push_back({key + ".duration", piece.duration, "must be more than 0, in s"});
  for (const auto& [name, value] :
       {std::pair{".strain", piece.strain}, {".rate", piece.rate}, {".acceleration", piece.acceleration}})
    if (!std::isfinite(value)) broken.push_back({key + name, value, "must be a finite number"});
}

/// Checks the largest and smallest strain, at an end or at the vertex.
void check_range(const StrainPiece& piece, const std::string& key, std::vector<Violation>& broken) {
  double low = std::min(piece.strain, piece.strain_at(piece.duration));
  double high = std::max(piece.strain, piece.strain_at(piece.duration));
  const double vertex = piece.acceleration == 0 ? -1 : -piece.rate / piece.acceleration;
  if (vertex > 0 && vertex < piece.duration) {
    low = std::min(low, piece.strain_at(vertex));
    high = std::max(high, piece.strain_at(vertex));
  }
  if (low < -rounding) broken.push_back({key + ".strain", low, "must be at least 0 throughout"});
  if (!(high < 1)) broken.push_back({key + ".strain", high, "must be less than 1 throughout"});
}

}  // namespace

StrainHistory constant_rate_test(double rate, double strain) { return cyclic_test(rate, strain, 0, 1); }

StrainHistory parabolic_test(double rate, double strain) {
  Rules().rate(rate).peak(strain).done();
  const double up = strain / rate;
  return {{{2 * up, 0, 2 * rate, -2 * rate / up}}};
}

StrainHistory ramp_and_hold_test(double rate, double strain, double hold) {
  Rules().rate(rate).peak(strain).positive("hold", hold, "s").done();
  return {{straight(0, strain, rate), {hold, strain, 0, 0}}};
}

StrainHistory cyclic_test(double rate, double strain, double low, int cycles) {
  Rules()
      .rate(rate)
      .peak(strain)
      .require(low >= 0 && low < strain, "low", low, "must be at least 0 and less than the largest strain")
      .require(cycles >= 1 && cycles <= 1000, "cycles", cycles, "must be from 1 to 1000")
      .done();
  StrainHistory history;
  for (int i = 0; i < cycles; ++i) {
    history.pieces.push_back(straight(i == 0 ? 0 : low, strain, rate));
    history.pieces.push_back(straight(strain, low, rate));
  }
  return history;
}

StrainHistory measured_test(const std::vector<double>& times, const std::vector<double>& strains) {
  if (times.size() != strains.size() || times.size() < 2)
    throw std::invalid_argument(fmt::format("{} times and {} strains: give equal numbers of both, at least 2",
                                            times.size(), strains.size()));
  StrainHistory history;
  for (std::size_t i = 1; i < times.size(); ++i) {
    const double duration = times[i] - times[i - 1];
    history.pieces.push_back({duration, strains[i - 1], (strains[i] - strains[i - 1]) / duration, 0});
  }
  Rules().none_of(violations(history)).done();
  return history;
}

std::vector<Violation> violations(const StrainHistory& history) {
  std::vector<Violation> broken;
  const auto& pieces = history.pieces;
  if (pieces.empty()) broken.push_back({"pieces", 0, "there must be at least one piece"});
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const std::string key = fmt::format("pieces[{}]", i);
    const std::size_t before = broken.size();
    check_numbers(pieces[i], key, broken);
    if (broken.size() > before) continue;
    check_range(pieces[i], key, broken);
    const double expected = i == 0 ? 0 : pieces[i - 1].strain_at(pieces[i - 1].duration);
    if (std::abs(pieces[i].strain - expected) > rounding)
      broken.push_back({key + ".strain", pieces[i].strain,
                        i == 0 ? "must be 0: a history starts at first contact"
                               : "must be the strain at which the previous piece ends"});
  }
  return broken;
}

}  // namespace dashpad::laboratory
