#include "dashpad/report/pulse_text.hpp"

#include <cmath>

#include <fmt/format.h>

#include "dashpad/version.hpp"
#include "io/text.hpp"
#include "report/pulse_words.hpp"

namespace dashpad {

namespace {

double in_g(double acceleration) { return acceleration / standard_gravity; }

/// 0 for what is 0 up to rounding, compared with a stretch of the pulse.
double without_rounding(double time, double length) { return std::abs(time) < 1e-9 * length ? 0 : time; }

/// "from 12.3 to 27.3 ms".
std::string stretch(double begin, double end, const UnitSystem& units) {
  const double length = end - begin;
  return fmt::format("from {} to {}", brief(value_in(units, without_rounding(begin, length), "s")),
                     brief_quantity(without_rounding(end, length), "s", units));
}

std::string row(const std::string& label, const std::string& value, const std::string& unit, double error,
                const std::string& remark) {
  const std::string shown_error = error > 0 ? "± " + percentage(error) : "";
  std::string line = fmt::format("  {:<19}{:>11} {:<7} {}", label, value, unit, shown_error);
  if (!shown_error.empty() && !remark.empty()) line += "  ";
  line += remark;
  line.erase(line.find_last_not_of(' ') + 1);
  return line + "\n";
}

std::string hic_row(const std::string& label, const Hic& hic, double error, const UnitSystem& units) {
  return row(label, significant(hic.value), "", error, stretch(hic.begin, hic.end, units));
}

std::string clip_row(const std::string& label, const Clip& clip, double error, const std::string& kind,
                     const UnitSystem& units) {
  return row(label, significant(in_g(clip.level)), "g", error,
             kind + (clip.end > clip.begin ? ", " + stretch(clip.begin, clip.end, units) : ""));
}

std::string origin(const MeasuredColumn& column, const std::string& si_unit) {
  const std::string from = column.unit_origin == "given"    ? "as given"
                           : column.unit_origin == "header" ? "from the file"
                                                            : "by the format";
  std::string text = fmt::format("{} in {} ({})", one_line(column.name), column.unit, from);
  if (!column.sensitivity.empty()) text += ", at " + one_line(column.sensitivity);
  if (column.factor != 1) text += fmt::format(", 1 {} = {:.7g} {}", column.unit, column.factor, si_unit);
  return text;
}

std::string offset_line(const PulseReport& report, const UnitSystem& units) {
  if (!report.offset) return "";
  const auto& [offset, given, taken_off, with, without] = *report.offset;
  const std::string interval =
      fmt::format("the mean of {} samples {}", offset.samples, stretch(offset.begin, offset.end, units));
  const std::string scatter = "scatter " + each_in_g(offset.scatter, report.figures.peak.magnitude);
  const std::string mean = each_in_g(offset.mean, report.figures.peak.magnitude);
  if (!taken_off) return fmt::format("  quiet part    {}, {}; {}\n", mean, interval, scatter);
  return fmt::format("  zeroed        {} taken off, {}; {}; {}\n", mean, interval, scatter,
                     change_of_hic15(*report.offset));
}

std::string source(const PulseReport& report, const UnitSystem& units) {
  const MeasuredPulse& measured = report.measured;
  const Pulse& pulse = measured.pulse;
  std::string text = fmt::format("{} ({})\n", one_line(report.file), measured.format);
  text += fmt::format("  time          {}\n", origin(measured.time, "s"));
  for (const MeasuredColumn& column : measured.acceleration)
    text += fmt::format("  acceleration  {}\n", origin(column, "m/s2"));
  if (measured.resultant)
    text += fmt::format("  resultant of {} directions{}\n", measured.acceleration.size(),
                        report.filter ? ", each filtered, then combined" : "");
  text += fmt::format("  {} samples {}\n", pulse.time.size(),
                      stretch(pulse.time.front(), pulse.time.back(), units));
  if (report.resampled_to)
    text += fmt::format("  resampled every {}: {} samples\n",
                        brief_quantity(*report.resampled_to, "s", units), report.pulse.time.size());
  text += offset_line(report, units);
  text += fmt::format("  filter        {}\n", report.filter ? filter_words(*report.filter) : "none");
  for (const std::string& remark : measured.remarks) text += "  REMARK: " + one_line(remark) + "\n";
  for (const Flag& flag : report.flags) text += "  " + flag.text + "\n";
  return text;
}

}  // namespace

std::string filter_words(const PulseFilter& filter) {
  return fmt::format("CFC{}, corner of {}, ends {}", filter.channel_frequency_class,
                     filter.corner == Corner::sae_j211 ? "SAE J211" : "ISO 6487", to_string(filter.ends));
}

std::string injury_text(const InjuryFigures& figures, const UnitSystem& units) {
  const auto& errors = figures.errors;
  const double longest = figures.hic_unlimited.end - figures.hic_unlimited.begin;
  std::string text = row("Peak acceleration", significant(in_g(figures.peak.magnitude)), "g", errors.peak,
                         "at " + brief_quantity(without_rounding(figures.peak.time, longest), "s", units));
  text += hic_row("HIC15", figures.hic15, errors.hic15, units);
  text += hic_row("HIC36", figures.hic36, errors.hic36, units);
  text += hic_row("HIC, any window", figures.hic_unlimited, errors.hic_unlimited, units);
  text += row("HIC(d)", significant(figures.hic_d), "", errors.hic_d, "from HIC36");
  text += clip_row("3 ms clip", figures.contiguous_3ms, errors.contiguous_3ms, "in one stretch", units);
  text += clip_row("3 ms cumulative", figures.cumulative_3ms, errors.cumulative_3ms, "in all", units);
  text += row("Severity index", significant(figures.severity_index), "", errors.severity_index, "Gadd");
  text += row("Velocity change", significant(value_in(units, figures.velocity_change, "m/s")),
              shown_unit(unit_for(units, "m/s")), errors.velocity_change, "");
  return text;
}

std::string pulse_text(const PulseReport& report, const UnitSystem& units) {
  std::string text = source(report, units) + "\n" + injury_text(report.figures, units);
  if (report.impact)
    text += row("Restitution", significant(*restitution(report)), "", 0,
                "of an impact at " + brief_quantity(report.impact->speed, "m/s", units));
  for (const WindowedHic& of : report.windows)
    text += hic_row("HIC, " + brief(1e3 * of.longest_window) + " ms", of.hic, 0, units);
  for (const DwellTime& of : report.dwells)
    text +=
        row("Above " + brief(in_g(of.level)) + " g", significant(value_in(units, of.cumulative, "s")),
            shown_unit(unit_for(units, "s")), 0, "in all; longest " + brief_quantity(of.longest, "s", units));
  return text + fmt::format(
                    "\nHIC and severity index in g^2.5 s; the pulse is linear between its samples "
                    "(dashpad {})\n",
                    version());
}

}  // namespace dashpad
