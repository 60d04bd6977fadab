#include "dashpad/impact/contact_snapshot.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <type_traits>

#include "impact/contacts.hpp"
#include "impact/neighbours.hpp"
#include "model/contact/column_field.hpp"
#include "model/contact/curve_contact.hpp"
#include "model/contact/foam_contact.hpp"
#include "model/contact/layered_contact.hpp"

namespace dashpad {

namespace {

/// Resolution of the stations, finer than in most runs.
constexpr double start_resolution = 0.02;
/// Usual number of points of a snapshot, more than a picture shows.
constexpr int max_points = 160;
/// Relative change of the stress from which on a point is kept anyway, as near the axis of a closing pad.
constexpr double largest_jump = 0.05;

/// The entries of the history that are shown, increasing.
std::vector<std::size_t> chosen_entries(const History& history) {
  const auto peak = static_cast<std::size_t>(std::max_element(history.force.begin(), history.force.end()) -
                                             history.force.begin());
  const double top = history.time[peak];
  const double end = history.time.back();
  std::vector<double> times{top / 4, top / 2, top};
  if (peak + 1 == history.size())
    times.insert(times.begin() + 2, 0.75 * top);
  else
    times.insert(times.end(), {top + 0.5 * (end - top), top + 0.9 * (end - top)});
  std::vector<std::size_t> entries;
  for (const double time : times) {
    auto after = std::ranges::lower_bound(history.time, time);
    if (after == history.time.end()) --after;
    if (after != history.time.begin() && time - *(after - 1) < *after - time) --after;
    const auto entry = static_cast<std::size_t>(after - history.time.begin());
    const bool later = entries.empty() ? entry > 0 : entry > entries.back();
    if (later && history.force[entry] > 0) entries.push_back(entry);
  }
  return entries;
}

/// A snapshot without points; its force is that of the columns without the help of neighbours.
ContactSnapshot empty_snapshot(const ImpactCase& impact, const History& history, std::size_t entry) {
  ContactSnapshot snapshot;
  snapshot.time = history.time[entry];
  snapshot.force = history.force_of_pad()[entry] / factor_of_columns(impact)(history.penetration[entry]);
  const auto peak = std::max_element(history.force.begin(), history.force.end()) - history.force.begin();
  const auto place = static_cast<std::ptrdiff_t>(entry) - peak;
  snapshot.when = place < 0 ? "loading" : place == 0 ? "peak force" : "unloading";
  return snapshot;
}

void add_point(ContactSnapshot& snapshot, double radius, double strain, double stress) {
  snapshot.radius.push_back(radius);
  snapshot.strain.push_back(strain);
  snapshot.stress.push_back(std::max(stress, 0.0));
}

/// Adds the pressing columns, out to where the stress vanishes.
template <class Law>
void look_at(const ColumnField<Law>& field, double penetration, const Sections& nose, double thickness,
             ContactSnapshot& snapshot) {
  const auto [pressing, edge] = field.stressed();
  if (pressing == 0) return;
  const double spacing = nose.radius(edge) / max_points;
  // Below a flat tip all columns are as on the axis.
  if (nose.tip > 0) add_point(snapshot, 0, field.column(0).strain, field.column(0).stress);
  for (std::size_t j = 0; j < pressing; ++j) {
    const auto column = field.column(j);
    const double radius = nose.radius(column.depth);
    const bool kept =
        j == 0 || j + 1 == pressing || radius - snapshot.radius.back() >= spacing ||
        std::abs(column.stress - snapshot.stress.back()) > largest_jump * snapshot.stress.back();
    if (kept) add_point(snapshot, radius, column.strain, column.stress);
  }
  if (nose.radius(edge) > snapshot.radius.back())
    add_point(snapshot, nose.radius(edge), (penetration - edge) / thickness,
              edge < nose.depth ? 0 : field.column(pressing - 1).stress);
}

/// Adds points at even radii up to `edge`, m; `point_at(depth)` returns strain and stress of a column.
template <class PointAt>
void add_evenly(ContactSnapshot& snapshot, const Sections& nose, double edge, PointAt&& point_at) {
  for (int k = 0; k <= max_points; ++k) {
    const double radius = edge * k / max_points;
    const auto [strain, stress] = point_at(nose.depth_at(radius));
    add_point(snapshot, radius, std::max(strain, 0.0), stress);
  }
}

/// Leads a contact that locks at a penetration through the history; `look(entry, snapshot)` adds its columns.
template <IsContact Contact, class Look>
std::vector<ContactSnapshot> replayed(const ImpactCase& impact, const History& history, Contact& contact,
                                      double lock, Look&& look) {
  std::vector<ContactSnapshot> snapshots;
  std::size_t now = 0;
  for (const std::size_t entry : chosen_entries(history)) {
    for (; now < entry; ++now)
      contact.accept(contact.trial(history.penetration[now + 1] - history.penetration[now], history.time[now],
                                   history.time[now + 1] - history.time[now]));
    ContactSnapshot snapshot = empty_snapshot(impact, history, entry);
    snapshot.determined = history.penetration[entry] < lock * (1 - 1e-12);
    look(history.penetration[entry], snapshot);
    if (snapshot.radius.size() > 1) snapshots.push_back(std::move(snapshot));
  }
  return snapshots;
}

double deepest(const History& history) { return *std::ranges::max_element(history.penetration); }

template <class Law>
std::vector<ContactSnapshot> from_columns(const Law& law, const ImpactCase& impact, const History& history) {
  const double thickness = impact.pad.thickness;
  const Sections nose = sections_of(impact);
  ColumnField<Law> field(law, thickness, nose, ColumnMath::plain);
  field.start(start_resolution, deepest(history));
  return replayed(impact, history, field, field.lock_penetration(),
                  [&](double penetration, ContactSnapshot& snapshot) {
                    look_at(field, penetration, nose, thickness, snapshot);
                  });
}

std::vector<ContactSnapshot> from_foam(const FoamContact::Law& law, const ImpactCase& impact,
                                       const History& history) {
  const double thickness = impact.pad.thickness;
  const Sections nose = sections_of(impact);
  FoamContact contact(law, thickness, nose, 1, ColumnMath::vector, impact.pad.earlier_penetration);
  contact.start(start_resolution, thickness);
  const auto look = [&](double, ContactSnapshot& snapshot) {
    const double edge = contact.contact_radius();
    if (edge > 0) add_evenly(snapshot, nose, edge, [&](double depth) { return contact.column(depth); });
  };
  return replayed(impact, history, contact, contact.crater() + contact.lock_penetration(), look);
}

std::vector<ContactSnapshot> from_layers(const ImpactCase& impact, const History& history) {
  const Sections nose = sections_of(impact);
  LayeredContact contact(layers_of(impact.pad), nose);
  contact.start(start_resolution, deepest(history));
  const auto look = [&](double penetration, ContactSnapshot& snapshot) {
    // Below a flat tip all columns are as on the axis.
    if (nose.tip > 0 && contact.column(0).stress > 0)
      add_point(snapshot, 0, contact.column(0).strain, contact.column(0).stress);
    for (std::size_t j = 0; j < contact.touched_columns(); ++j)
      if (const auto column = contact.column(j); column.strain > 0 && column.stress > 0)
        add_point(snapshot, nose.radius(column.depth), column.strain, column.stress);
    if (const double edge = contact.contact_radius();
        !snapshot.radius.empty() && edge > snapshot.radius.back())
      add_point(snapshot, edge, (penetration - nose.depth_at(edge)) / impact.pad.thickness,
                nose.depth_at(edge) < nose.depth ? 0 : snapshot.stress.back());
  };
  return replayed(impact, history, contact, contact.lock_penetration(), look);
}

/// Without memory the stress is that of the curve, which foam that does not recover leaves once it stops.
std::vector<ContactSnapshot> from_curve(const StressCurve& curve, const ImpactCase& impact,
                                        const History& history) {
  const Sections nose = sections_of(impact);
  const double thickness = impact.pad.thickness;
  const CurveContact contact(curve, true, thickness, nose);
  std::vector<ContactSnapshot> snapshots;
  for (const std::size_t entry : chosen_entries(history)) {
    const double penetration = history.penetration[entry];
    if (!(penetration > 0)) continue;
    ContactSnapshot snapshot = empty_snapshot(impact, history, entry);
    const double share = snapshot.force / contact.force(penetration);
    snapshot.determined = std::abs(share - 1) < 1e-6;
    add_evenly(snapshot, nose, nose.radius(penetration), [&](double depth) {
      const double strain = (penetration - depth) / thickness;
      return std::pair(strain, share * curve.at(std::max(strain, std::numeric_limits<double>::min())));
    });
    snapshots.push_back(std::move(snapshot));
  }
  return snapshots;
}

}  // namespace

double ContactSnapshot::force_of_stress() const {
  double sum = 0;
  for (std::size_t i = 1; i < radius.size(); ++i)
    sum += (stress[i - 1] + stress[i]) / 2 * (radius[i] * radius[i] - radius[i - 1] * radius[i - 1]);
  return std::numbers::pi * sum;
}

std::vector<ContactSnapshot> contact_snapshots(const ImpactCase& impact, const History& history) {
  if (history.size() < 2) return {};
  if (!impact.pad.layers.empty()) return from_layers(impact, history);
  return std::visit(
      [&](const auto& law) {
        using Law = std::decay_t<decltype(law)>;
        if constexpr (IsMemoryless<Law>)
          return from_curve(law.curve(), impact, history);
        else if constexpr (SharesSlip<Law>)
          return from_foam(law, impact, history);
        else
          return from_columns(law, impact, history);
      },
      scaled(impact.pad.material.law, stress_factor(impact.pad.condition, impact.pad.material)));
}

}  // namespace dashpad
