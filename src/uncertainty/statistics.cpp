// What is known by its scatter: samples of the foam, the unknowns of a fit, and what a fitted law misses.

#include <algorithm>

#include <fmt/format.h>
#include <boost/math/distributions/students_t.hpp>

#include "dashpad/case/case_quantity.hpp"
#include "dashpad/quantities/constants.hpp"
#include "uncertainty/line.hpp"

namespace dashpad::uncertainty {

namespace {

void add_scatter(const ImpactCase& impact, const std::vector<Part>& parts, Open& open) {
  std::vector<double> scatter;
  std::string unmeasured;
  for (const Part& part : parts) {
    scatter.push_back(part.material->uncertainty.scatter.value_or(0));
    if (!part.material->uncertainty.scatter)
      unmeasured += (unmeasured.empty() ? "" : ", ") + part.material->name;
  }
  if (!unmeasured.empty())
    open.sources.push_back({Source::scatter, "how the foam scatters from sample to sample",
                            fmt::format("nothing says that it was measured ({})", unmeasured)});
  if (std::ranges::all_of(scatter, [](double share) { return share == 0; })) return;
  open.sources.push_back(
      {Source::scatter,
       fmt::format("how the foam scatters from sample to sample (standard deviation {:.2g} %)",
                   100 * std::ranges::max(scatter)),
       ""});
  Line line{.source = Source::scatter, .is_statistical = true};
  line.ends = {-line.deviations, line.deviations};
  line.at = [impact, scatter](double place) {
    return with_parts(impact, [&](Material&, PadCondition& condition, std::size_t i) {
      condition.scale *= std::max(1 + place * scatter[i], 0.01);
    });
  };
  open.lines.push_back(std::move(line));
}

/// The case with the values of one end of an axis.
ImpactCase with_values(ImpactCase impact, const std::string& prefix, const PosteriorAxes& axes,
                       std::size_t axis, bool is_plus) {
  const CaseQuantities quantities = quantities_of(impact);
  for (std::size_t i = 0; i < axes.keys.size(); ++i) {
    if (const CaseQuantity* const of = quantities.find(prefix + axes.keys[i]))
      of->set(impact, (is_plus ? axes.plus : axes.minus)[axis][i]);
  }
  return impact;
}

void add_posterior(const ImpactCase& impact, const std::vector<Part>& parts, Open& open) {
  bool any = false;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const PosteriorAxes& axes = parts[i].material->uncertainty.posterior;
    const std::string prefix = impact.pad.layers.empty() ? "pad." : fmt::format("pad.layers[{}].", i + 1);
    for (std::size_t axis = 0; axis < axes.minus.size(); ++axis) {
      any = true;
      // One standard deviation is solved for, and taken 1.96 times.
      open.lines.push_back(
          {.source = Source::posterior,
           .ends = {-1, 1},
           .at = [impact, prefix, axes,
                  axis](double place) { return with_values(impact, prefix, axes, axis, place > 0); },
           .is_statistical = true,
           .deviations = 1});
    }
  }
  if (any)
    open.sources.push_back({Source::posterior, "what the data of the fit leave open of its unknowns", ""});
}

void add_misfit(const std::vector<Part>& parts, Open& open) {
  Shares shares{.source = Source::misfit};
  const Misfit* worst = nullptr;
  for (const Part& part : parts)
    if (const auto& misfit = part.material->uncertainty.misfit) {
      if (worst == nullptr || misfit->hic > worst->hic) worst = &*misfit;
      shares.acceleration = std::max(shares.acceleration, misfit->peak_acceleration);
      shares.hic = std::max(shares.hic, misfit->hic);
      shares.rebound = std::max(shares.rebound, misfit->rebound_speed);
      shares.penetration = std::max(shares.penetration, misfit->penetration);
    }
  if (worst == nullptr) return;
  open.shares.push_back(shares);
  open.sources.push_back(
      {Source::misfit,
       fmt::format("what the fitted law misses of {} {} impact{}", worst->impacts,
                   worst->is_held_out ? "predicted" : "fitted", worst->impacts == 1 ? "" : "s"),
       ""});
}

}  // namespace

void add_statistics(const ImpactCase& impact, const Summary& summary, Open& open) {
  const std::vector<Part> parts = parts_of(impact.pad, summary);
  add_scatter(impact, parts, open);
  add_posterior(impact, parts, open);
  add_misfit(parts, open);
}

double student_95(double degrees_of_freedom) {
  if (!(degrees_of_freedom > 0)) return infinite;
  return quantile(complement(boost::math::students_t(degrees_of_freedom), 0.025));
}

}  // namespace dashpad::uncertainty
