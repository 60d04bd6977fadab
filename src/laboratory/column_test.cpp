#include "dashpad/laboratory/column_test.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <variant>

#include <fmt/format.h>

#include "laboratory/column.hpp"
#include "laboratory/columns.hpp"
#include "laboratory/viscous_stress.hpp"

namespace dashpad::laboratory {

Motion Stretch::after_start(double x) const {
  return {std::max(start.strain + x * (start.rate + x * acceleration / 2), 0.0),
          start.rate + x * acceleration};
}

Motion Stretch::before_end(double y) const {
  return {std::max(end.strain - y * (end.rate - y * acceleration / 2), 0.0), end.rate - y * acceleration};
}

Stretch Stretch::part(double from, double to) const {
  return {time + from, to - from, from == 0 ? start : at(from), to == duration ? end : at(to), acceleration};
}

int Stretch::direction() const {
  const double twice_mean = start.rate + end.rate;
  return twice_mean > 0 ? 1 : twice_mean < 0 ? -1 : 0;
}

std::vector<Arc> arcs_of(const StrainHistory& history) {
  std::vector<Arc> arcs;
  double time = 0;
  for (std::size_t i = 0; i < history.pieces.size(); ++i) {
    const StrainPiece& piece = history.pieces[i];
    const bool last = i + 1 == history.pieces.size();
    // What the next piece begins with counts, so that no rounding opens a gap between the two.
    const Motion start{std::max(piece.strain, 0.0), piece.rate};
    const double reached = last ? piece.strain_at(piece.duration) : history.pieces[i + 1].strain;
    const Motion end{reached < 1e-15 ? 0 : reached, piece.rate_at(piece.duration)};
    const double vertex = piece.acceleration == 0 ? -1 : -piece.rate / piece.acceleration;
    if (vertex > 0 && vertex < piece.duration) {
      const Motion turn{start.strain + piece.rate * vertex / 2, 0};
      arcs.push_back({{time, vertex, start, turn, piece.acceleration}, piece.duration, 0});
      arcs.push_back(
          {{time + vertex, piece.duration - vertex, turn, end, piece.acceleration}, piece.duration, vertex});
    } else {
      arcs.push_back({{time, piece.duration, start, end, piece.acceleration}, piece.duration, 0});
    }
    time += piece.duration;
  }
  return arcs;
}

double duration_of(const StrainHistory& history) {
  double time = 0;
  for (const StrainPiece& piece : history.pieces) time += piece.duration;
  return time;
}

double end_of_first_loading(const StrainHistory& history) {
  double begin = 0, loaded_until = 0;
  for (const StrainPiece& piece : history.pieces) {
    const bool grows = piece.rate > 0 || (piece.rate == 0 && piece.acceleration > 0);
    if (!grows && loaded_until > 0) break;
    const double turn = piece.acceleration < 0 ? -piece.rate / piece.acceleration : piece.duration;
    if (grows) loaded_until = begin + std::min(turn, piece.duration);
    if (grows && turn < piece.duration) break;
    begin += piece.duration;
  }
  return loaded_until;
}

double strain_at(const StrainHistory& history, double time) {
  double begin = 0;
  for (const StrainPiece& piece : history.pieces) {
    if (time <= begin + piece.duration || &piece == &history.pieces.back())
      return piece.strain_at(std::min(time - begin, piece.duration));
    begin += piece.duration;
  }
  return 0;
}

namespace {

constexpr int fewest_places = 2, max_places = 100000;
constexpr double max_places_in_all = 1e7;

void check(const PadLaw& law, const StrainHistory& history, int places) {
  Rules rules;
  rules.none_of(violations(law)).none_of(violations(history));
  if (places < fewest_places || places > max_places)
    rules.require(false, "places", places, fmt::format("must be {} to {}", fewest_places, max_places));
  else
    rules.require(static_cast<double>(history.pieces.size()) * places <= max_places_in_all, "places", places,
                  fmt::format("times pieces must be at most {}", max_places_in_all));
  rules.done();
}

/// Times from the arc's start, beyond it, at which there is output: the places of its piece, the ends of the
/// contact, the arc's end.
std::vector<double> output_times(const Arc& arc, const Contact& contact, int places) {
  std::vector<double> special{arc.duration};
  for (const double x : {contact.from, contact.to})
    if (contact.any && x > 0 && x < arc.duration) special.push_back(x);
  const double spacing = arc.piece_duration / places;
  std::vector<double> times = special;
  for (int i = 1; i < places; ++i) {
    const double x = i * spacing - arc.offset;
    const auto coincides = [&](double y) { return std::abs(x - y) < 1e-9 * spacing; };
    if (x > 1e-9 * spacing && x < arc.duration && std::none_of(special.begin(), special.end(), coincides))
      times.push_back(x);
  }
  std::sort(times.begin(), times.end());
  return times;
}

/// One column on its way, with the record of it.
template <class Column>
class Drive {
 public:
  Drive(Column column, int places) : column_(std::move(column)), places_(places) {}

  ColumnTest through(const std::vector<Arc>& arcs) {
    record_.add(arcs.front().time, arcs.front().start, {});
    for (const Arc& arc : arcs) follow(arc);
    return record_.finished();
  }

 private:
  using Kind = ColumnEvent::Kind;

  void follow(const Arc& arc) {
    const Contact contact = column_.enter(arc);
    const double before = record_.stress();
    const double after = contact.any && contact.from == 0 ? column_.at(0).value : 0;
    if (const int direction = arc.direction(); direction != 0) {
      if (direction != course_ && course_ != 0)
        record_.note(direction < 0 ? Kind::turned : Kind::reloaded, arc.time, arc.start.strain, before,
                     contact.taken_up ? before : after);
      course_ = direction;
    }
    if (contact.taken_up && contact.from == 0)
      record_.note(Kind::contact_taken_up, arc.time, arc.start.strain, before, after);
    if (contact.lost && !contact.any)
      record_.note(Kind::contact_lost, arc.time, arc.start.strain, before, after);
    if (after != before) record_.add(arc.time, arc.start, {after, 0});
    double last = 0;
    for (const double x : output_times(arc, contact, places_)) {
      put(arc, contact, last, x);
      last = x;
    }
    column_.leave();
  }

  void put(const Arc& arc, const Contact& contact, double last, double x) {
    const Motion motion = arc.part(0, x).end;
    const bool within = contact.any && last >= contact.from && x <= contact.to;
    if (within) {
      const auto power = [&](double t) { return column_.at(t).value * arc.at(t).rate; };
      // After a jump of the rate the stress may change within no time, and from strain zero it does.
      if (arc.direction() != 0)
        record_.work(last == contact.from ? integral_from_singularity(
                                                [&](double t) { return power(last + t); }, 0, x - last, 1e-9)
                                          : integral(power, last, x, 1e-9, 12));
    }
    const bool ends = contact.lost && x == contact.to;
    const WithError stress = within && !ends ? column_.at(x) : WithError{};
    record_.add(arc.time + x, motion, stress);
    if (ends && contact.any) record_.note(Kind::contact_lost, arc.time + x, motion.strain, 0, 0);
    if (contact.any && x == contact.from && x < arc.duration) {
      const WithError taken_up = column_.at(x);
      if (contact.taken_up)
        record_.note(Kind::contact_taken_up, arc.time + x, motion.strain, 0, taken_up.value);
      record_.add(arc.time + x, motion, taken_up);
    }
  }

  Column column_;
  int places_;
  Record record_;
  int course_ = 0;  ///< of the strain, when it last was not still
};

/// Gives `use` a column of the law.
template <class Use>
auto with_column(const PadLaw& law, Use&& use) {
  return std::visit(
      [&](const auto& alternative) {
        using Law = std::decay_t<decltype(alternative)>;
        if constexpr (IsMemoryless<Law>)
          return use(CurveColumn<Law>(alternative));
        else if constexpr (SharesSlip<Law>)
          return use(FoamColumn(alternative));
        else if constexpr (std::is_same_v<Law, ViscoelasticFoam>)
          return use(MaxwellColumn(alternative));
        else
          return use(ViscousColumn<Law>(alternative));
      },
      law);
}

/// Takes a column through an arc; the stress at its end, Pa.
template <class Column>
double stress_at_end(Column& column, const Arc& arc) {
  if constexpr (requires { column.pass(arc); }) {
    return column.pass(arc);
  } else {
    const Contact contact = column.enter(arc);
    const bool presses = contact.any && contact.to >= arc.duration && !contact.lost;
    const double stress = presses ? std::max(column.at(arc.duration).value, 0.0) : 0;
    column.leave();
    return stress;
  }
}

constexpr double rounding = 1e-9;  ///< of a strain

StrainPiece straight(double from, double to, double rate) {
  return {std::abs(to - from) / rate, from, to > from ? rate : -rate, 0};
}

void check_numbers(const StrainPiece& piece, const std::string& key, std::vector<Violation>& broken) {
  if (!(piece.duration > 0 && std::isfinite(piece.duration)))
    broken.push_back({key + ".duration", piece.duration, "must be more than 0 (s)"});
  for (const auto& [name, value] :
       {std::pair{".strain", piece.strain}, {".rate", piece.rate}, {".acceleration", piece.acceleration}})
    if (!std::isfinite(value)) broken.push_back({key + name, value, "must be a finite number"});
}

/// The strain is largest or smallest at an end or at the vertex.
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

/// At a vertex the rate is zero, not what rounding leaves of it.
double rate_in(const StrainPiece& piece, double time) {
  const double rate = piece.rate_at(time);
  return std::abs(rate) < 1e-13 * std::abs(piece.acceleration * time) ? 0 : rate;
}

}  // namespace

ColumnTest drive(const PadLaw& law, const StrainHistory& history, int places) {
  check(law, history, places);
  const std::vector<Arc> arcs = arcs_of(history);
  return with_column(law, [&](auto column) { return Drive(std::move(column), places).through(arcs); });
}

std::vector<double> stress_at_ends(const PadLaw& law, const StrainHistory& history, FoamMemo* memo) {
  const std::vector<Arc> arcs = arcs_of(history);
  const auto through = [&](auto column) {
    std::vector<double> stresses;
    stresses.reserve(history.pieces.size());
    for (std::size_t i = 0; i < arcs.size(); ++i) {
      const double stress = stress_at_end(column, arcs[i]);
      const bool ends_piece = i + 1 == arcs.size() || arcs[i + 1].offset == 0;
      if (ends_piece) stresses.push_back(stress);
    }
    return stresses;
  };
  if (const Foam* const foam = std::get_if<Foam>(&law); foam != nullptr && memo != nullptr)
    return through(FoamColumn(*foam, *memo));
  return with_column(law, through);
}

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
      .require(low >= 0 && low < strain, "low", low, "must be at least 0 and less than strain")
      .require(cycles >= 1 && cycles <= 1000, "cycles", cycles, "must be 1 to 1000")
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
    throw std::invalid_argument(fmt::format(
        "{} times and {} strains: there must be as many, and two at least", times.size(), strains.size()));
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
  if (pieces.empty()) broken.push_back({"pieces", 0, "there must be one piece at least"});
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
                               : "must be the strain at which the piece before ends"});
  }
  return broken;
}

StrainHistory split_at(const StrainHistory& history, const std::vector<double>& times) {
  const double shortest = 1e-12 * duration_of(history);
  StrainHistory split;
  double begin = 0;
  auto mark = times.begin();
  for (const StrainPiece& piece : history.pieces) {
    double done = 0;
    const auto add_until = [&](double end) {
      split.pieces.push_back({end - done, piece.strain_at(done), rate_in(piece, done), piece.acceleration});
      done = end;
    };
    for (; mark != times.end() && *mark - begin < piece.duration - shortest; ++mark)
      if (*mark - begin > done + shortest) add_until(*mark - begin);
    add_until(piece.duration);
    begin += piece.duration;
  }
  return split;
}

}  // namespace dashpad::laboratory
