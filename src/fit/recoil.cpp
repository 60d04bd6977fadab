#include "fit/recoil.hpp"

#include <algorithm>
#include <variant>

#include "fit/met.hpp"

namespace dashpad::fit {

using input::TomlNode;

namespace {

constexpr const char* key_of_recoil = "pad.parameters.recoil";
/// A test at more than this many times the rate of the base curve has stress that the rate added.
constexpr double clearly_faster = 2;
/// Of the largest strain: what a test has to come back for a way back.
constexpr double least_way_back = 0.1;

const TomlNode* in(const TomlNode* table, const char* key) { return table ? table->child(key) : nullptr; }

const FoamCurves* curves_with_rate(const Fit& fit) {
  const auto* const foam = std::get_if<Foam>(&fit.base.pad.material.law);
  return foam && !std::holds_alternative<NoRateEffect>(foam->curves.rate_effect) ? &foam->curves : nullptr;
}

bool shows_recoil(const ImpactMeasurement& impact) {
  return !impact.is_held_out &&
         (impact.pulse || std::ranges::any_of(impact.figures, [](const MeasuredFigure& of) {
            return of.figure == ImpactFigure::rebound_speed || of.figure == ImpactFigure::contact_time ||
                   of.figure == ImpactFigure::velocity_change;
          }));
}

bool shows_recoil(const MaterialMeasurement& test, double slowest_rate) {
  if (test.is_held_out || rates_of(test).highest <= clearly_faster * slowest_rate) return false;
  const auto largest = std::ranges::max_element(test.strain);
  return *std::min_element(largest, test.strain.end()) < (1 - least_way_back) * *largest;
}

}  // namespace

bool states_recoil(const TomlNode& fit_file, const std::vector<input::InputFile>& files) {
  if (in(in(fit_file.child("pad"), "parameters"), "recoil")) return true;
  return std::ranges::any_of(files, [](const input::InputFile& of) {
    if (of.file.extension() != ".toml") return false;
    const input::Reading<input::TomlFile> toml = input::read_toml(of.file);
    if (!toml) return false;
    const TomlNode* const pad = of.kind == "the material card" ? &toml->root : toml->root.child("pad");
    return in(in(pad, "parameters"), "recoil") && !in(toml->root.child("uncertainty"), "recoil");
  });
}

bool assumes_recoil(const Fit& fit) {
  return !fit.recoil_is_stated && curves_with_rate(fit) &&
         std::ranges::count(fit.unknowns, key_of_recoil, &Unknown::key) == 0;
}

void seek_recoil(Fit& fit) {
  if (!assumes_recoil(fit) || !violations(fit).empty()) return;
  const double slowest_rate = curves_with_rate(fit)->slowest_rate;
  const bool is_shown =
      std::ranges::any_of(fit.impacts, [](const auto& of) { return shows_recoil(of); }) ||
      std::ranges::any_of(fit.tests, [&](const auto& of) { return shows_recoil(of, slowest_rate); });
  if (!is_shown) return;
  fit.unknowns.push_back({.key = key_of_recoil, .unit = "1", .lowest = 0, .highest = 1, .start = 0.5});
  fit.unknowns.back().is_added = true;
  if (!violations(fit).empty()) fit.unknowns.pop_back();
}

}  // namespace dashpad::fit
