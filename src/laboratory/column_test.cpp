#include "dashpad/laboratory/column_test.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <variant>

#include <fmt/format.h>

#include "laboratory/arc.hpp"
#include "laboratory/columns.hpp"
#include "laboratory/viscous_stress.hpp"

namespace dashpad::laboratory {

namespace {

constexpr int fewest_places = 2, max_places = 100000;
constexpr double max_places_in_all = 1e7;

void check(const PadLaw& law, const StrainHistory& history, int places) {
  Rules rules;
  rules.none_of(violations(law)).none_of(violations(history));
  if (places < fewest_places || places > max_places)
    rules.require(false, "places", places, fmt::format("must be from {} to {}", fewest_places, max_places));
  else
    rules.require(static_cast<double>(history.pieces.size()) * places <= max_places_in_all, "places", places,
                  fmt::format("places times pieces must be at most {}", max_places_in_all));
  rules.done();
}

/// Times of output after the arc's start: the places of its piece, the ends of contact and of the arc.
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

/// Leads a column through a history and records it.
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
      // After a jump of the rate the stress may change within no time; from strain zero it does.
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
  int course_ = 0;  ///< direction of the strain when it last moved
};

/// Calls `use` with a column of the law.
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

/// Leads a column through an arc and returns the stress at its end, Pa.
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
  if (const Foam* const foam = std::get_if<Foam>(&law)) return through(FoamColumn(*foam, memo));
  return with_column(law, through);
}

}  // namespace dashpad::laboratory
