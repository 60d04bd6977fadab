/// The solver against the oracle of the tests (oracle/any_impact.hpp, and oracle/cvode_impact.hpp for laws 4
/// and 5), which shares nothing with it but the numbers of the case, over random cases.
///
///   compare_with_oracle --kind practice --cases 200 --tolerance 1e-4
///
/// or one case file (--file CASE.toml),
///
/// lists the blows of which a figure is off by more than the tolerance, what the oracle does not cover, and a
/// table by figure. Exit code 1 where more than --most figures are off.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "answers/case_kinds.hpp"
#include "answers/processor_time.hpp"
#include "dashpad/impact/blows.hpp"
#include "dashpad/input/case_file.hpp"
#include "oracle/any_impact.hpp"
#include "oracle/cvode_impact.hpp"

namespace dashpad::test {
namespace {

struct Settings {
  std::uint64_t cases = 200, from = 1, most = 0;
  double tolerance = 1e-4;
  std::string kind = "practice", file;
  bool all = false;
};

/// Laws 4 and 5 below a sphere on a plain support: what the oracle of these is for.
bool is_of_report(const ImpactCase& impact) {
  const PadLaw& law = impact.pad.material.law;
  const bool is_plain = impact.backing == Backing{} && !impact.support.is_rigid() &&
                        impact.impactor.gravity == 0 && impact.pad.sheet == 0 && !impact.pad.area;
  return is_plain && impact.pad.layers.empty() && std::holds_alternative<Sphere>(impact.impactor.nose) &&
         (std::holds_alternative<NineParameter>(law) || std::holds_alternative<TwentyOneParameter>(law));
}

oracle::AnyImpact report_law(const ImpactCase& impact) {
  const oracle::CvodeImpact of = oracle::solve_with_cvode(impact);
  using Ending = oracle::AnyImpact::Ending;
  oracle::AnyImpact answer;
  answer.ending = of.ending == oracle::Ending::released       ? Ending::released
                  : of.ending == oracle::Ending::bottomed_out ? Ending::bottomed_out
                                                              : Ending::failed;
  answer.peak_force = of.peak_force, answer.peak_motion = of.peak_motion;
  answer.peak_penetration = of.peak_penetration;
  if (of.release) answer.rebound_speed = std::fmax(-of.release->velocity, 0);
  answer.force_below_weight = of.weight, answer.contact_end = of.contact_end, answer.bottomed = of.bottomed;
  return answer;
}

struct FigureCount {
  std::uint64_t compared = 0, off = 0;
  double worst = 0;
};

class Comparison {
 public:
  explicit Comparison(const Settings& settings) : settings_(settings) {}

  void add(std::uint64_t seed, const ImpactCase& impact) {
    seed_ = seed;
    double begin = processor_seconds();
    const std::vector<Blow> blows = solve_blows(impact, {.tolerance = settings_.tolerance});
    seconds_ += processor_seconds() - begin;
    for (const Blow& blow : blows) {
      begin = processor_seconds();
      try {
        compare(blow.impact, blow.solution.summary,
                is_of_report(blow.impact) ? report_law(blow.impact) : oracle::solve_any(blow.impact));
      } catch (const std::invalid_argument& error) {
        ++left_out_[error.what()];
      }
      const double took = processor_seconds() - begin;
      oracle_seconds_ += took;
      if (took > longest_) longest_ = took, longest_seed_ = seed;
    }
  }

  /// Prints the table; how many figures are off.
  std::uint64_t print() const {
    std::uint64_t compared = 0, off = 0;
    fmt::print(
        "{} cases ({}) from seed {} at {:.0e}: {} blows compared, {} of them off; {:.1f} s of processor "
        "time, the oracle {:.1f} s (longest {:.1f} s, seed {})\n",
        settings_.cases, settings_.kind, settings_.from, settings_.tolerance, blows_, blows_off_, seconds_,
        oracle_seconds_, longest_, longest_seed_);
    for (const auto& [reason, count] : left_out_) fmt::print("  not compared: {} ({})\n", count, reason);
    for (const auto& [name, c] : figures_) {
      fmt::print("  {:26} {:6} compared {:4} off   worst {:.1e}\n", name, c.compared, c.off, c.worst);
      compared += c.compared, off += c.off;
    }
    fmt::print("  of {} figures {} are off by more than {:.0e}\n", compared, off, settings_.tolerance);
    return off;
  }

 private:
  void compare(const ImpactCase& impact, const Summary& s, const oracle::AnyImpact& o) {
    using Ending = oracle::AnyImpact::Ending;
    const bool ended = s.release || s.bottomed;
    if (!ended || o.ending == Ending::failed) {
      ++left_out_[ended ? "the oracle failed" : "the solver: " + to_string(s.status)];
      fmt::print("{} blow {} ({}): {}, the oracle {}\n", seed_, s.blow, words_of(impact), to_string(s.status),
                 o.ending == Ending::failed ? "failed" : "solved it");
      return;
    }
    // What the solver itself is not sure of is shown, and not counted.
    counts_ = s.trustworthy();
    if (counts_)
      ++blows_;
    else
      ++left_out_["the solver: " + to_string(s.status)];
    text_.clear();
    const double speed = impact.impactor.speed;
    const bool closed = o.ending == Ending::bottomed_out || s.bottomed;
    if (o.bottomed.has_value() != s.bottomed.has_value()) text_ += "  bottoming of one only";
    const auto moment = [&](const char* time, const char* velocity, const std::optional<Moment>& a,
                            const std::optional<Moment>& b) {
      if (!a || !b) return;
      figure(time, a->time, b->time, b->time);
      figure(velocity, a->velocity, b->velocity, std::max(std::abs(b->velocity), 1e-3 * speed));
    };
    moment("bottoming", "speed at bottoming", s.bottomed, o.bottomed);
    if (!closed) {
      figure("peak force", s.peak_force.value_or(0), o.peak_force, o.peak_force);
      figure("peak motion", s.peak_motion, o.peak_motion, o.peak_motion);
      figure("peak penetration", s.peak_penetration, o.peak_penetration, o.peak_penetration);
      figure("rebound speed", s.rebound_speed.value_or(0), o.rebound_speed,
             std::max(o.rebound_speed, 1e-3 * speed));
      moment("end of contact", "speed at end of contact", s.contact_end, o.contact_end);
      moment("force below weight", "speed, force below weight", s.force_below_weight, o.force_below_weight);
      if (s.support) {
        if (const auto force = s.support->peak_transmitted)
          figure("transmitted force", *force, o.peak_transmitted, o.peak_transmitted);
        figure("deflection", s.support->peak_deflection, o.peak_deflection, o.peak_deflection);
        if (s.support->set) figure("set", *s.support->set, o.set, o.peak_deflection);
        if (s.support->body_speed) figure("body speed", *s.support->body_speed, o.body_speed, speed);
      }
    }
    blows_off_ += counts_ && !text_.empty();
    if (!text_.empty() || settings_.all)
      fmt::print("{} blow {} ({}){}:{}\n", seed_, s.blow, words_of(impact),
                 counts_ ? "" : " " + to_string(s.status), text_);
  }

  void figure(const char* name, double value, double truth, double scale) {
    if (!(scale > 0)) return;
    FigureCount unsure;
    FigureCount& count = counts_ ? figures_[name] : unsure;
    const double difference = std::abs(value - truth) / scale;
    ++count.compared;
    count.worst = std::max(count.worst, difference);
    if (difference <= settings_.tolerance) return;
    ++count.off;
    text_ += fmt::format("  {} {:.8g} / {:.8g} ({:.1e})", name, value, truth, difference);
  }

  const Settings& settings_;
  std::uint64_t seed_ = 0, blows_ = 0, blows_off_ = 0, longest_seed_ = 0;
  double seconds_ = 0, oracle_seconds_ = 0, longest_ = 0;
  bool counts_ = true;
  std::string text_;
  std::map<std::string, FigureCount> figures_;
  std::map<std::string, std::uint64_t> left_out_;
};

int run(int count, char** arguments) {
  Settings settings;
  CLI::App app{
      "The solver against the oracle over random cases; exit code 1 if more than --most figures are off"};
  app.add_option("--cases", settings.cases, "Number of cases")->capture_default_str();
  app.add_option("--from", settings.from, "First seed")->capture_default_str();
  app.add_option("--most", settings.most, "Figures that may be off")->capture_default_str();
  app.add_option("--kind", settings.kind, "Which cases are drawn")
      ->check(CLI::IsMember(names_of_case_kinds()))
      ->capture_default_str();
  app.add_option("--tolerance", settings.tolerance, "Of the answers")
      ->check(CLI::Range(1e-8, 1e-2))
      ->capture_default_str();
  app.add_option("--file", settings.file, "A case file in the place of random cases")
      ->check(CLI::ExistingFile);
  app.add_flag("--all", settings.all, "List every blow, not only those with a figure off");
  CLI11_PARSE(app, count, arguments);
  std::setvbuf(stdout, nullptr, _IOLBF, 1 << 12);  // long runs are read as they go
  Comparison comparison(settings);
  if (!settings.file.empty())
    comparison.add(0, input::read_case(settings.file, std::string(DASHPAD_SOURCE_DIR) + "/materials").impact);
  else
    for (std::uint64_t i = 0; i < settings.cases; ++i)
      comparison.add(settings.from + i, draw_case(settings.kind, settings.from + i));
  return comparison.print() <= settings.most ? 0 : 1;
}

}  // namespace
}  // namespace dashpad::test

int main(int count, char** arguments) {
  try {
    return dashpad::test::run(count, arguments);
  } catch (const std::exception& error) {
    fmt::print(stderr, "compare_with_oracle: {}\n", error.what());
    return 2;
  }
}
