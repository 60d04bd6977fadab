// Cases of include/dashpad.h.

#include <algorithm>
#include <array>
#include <string_view>

#include "dashpad/quantities/constants.hpp"
#include "handles.hpp"
#include "input/disk.hpp"
#include "output/text/case_toml.hpp"

using dashpad::CaseQuantities;
using dashpad::CaseQuantity;
using dashpad::ImpactCase;
using dashpad::Violation;
using dashpad::input::Fault;
using dashpad::input::InputError;
using namespace dashpad::c;

namespace {

void take(dashpad_case& given, dashpad::input::CaseFile read) {
  given.read = std::move(read);
  given.quantities = std::make_shared<const CaseQuantities>(quantities_of(given.read.impact));
  given.toml.clear();
}

/// The settings with one more, in place of an earlier one of the same key. A material replaces the numbers of
/// the one before.
std::vector<std::string> with_setting(std::vector<std::string> settings, const std::string& key,
                                      const std::string& value) {
  constexpr std::string_view material = ".material";
  const bool is_material = key.ends_with(material);
  const std::string owner = is_material ? key.substr(0, key.size() - material.size()) : "";
  std::erase_if(settings, [&](const std::string& setting) {
    if (setting.starts_with(key + "=")) return true;
    return is_material &&
           std::ranges::any_of(std::array{".parameters.", ".curve.", ".rate."},
                               [&](const char* part) { return setting.starts_with(owner + part); });
  });
  settings.push_back(key + "=" + value);
  return settings;
}

const CaseQuantity* number_at(const dashpad_case* given, std::size_t i) {
  return i < dashpad_case_size(given) ? &*(given->quantities->begin() + std::ptrdiff_t(i)) : nullptr;
}

}  // namespace

dashpad_case* dashpad_case_read(const char* file, const char* text, const char* materials,
                                dashpad_faults** faults) {
  return guarded(faults, [&] {
    auto made = std::make_unique<dashpad_case>();
    made->file = text_of(file);
    made->materials = text_of(materials);
    made->is_file = text == nullptr;
    made->text = text == nullptr ? dashpad::input::read_text_file(made->file).value() : text;
    take(*made, dashpad::input::read_case_text(made->text, made->file, made->materials).value());
    return made.release();
  });
}
dashpad_case* dashpad_case_copy(const dashpad_case* given) {
  return guarded(nullptr, [&] { return std::make_unique<dashpad_case>(of(given)).release(); });
}
void dashpad_case_free(dashpad_case* given) { delete given; }

int dashpad_case_set(dashpad_case* given, const char* key, const char* value, dashpad_faults** faults) {
  return guarded(faults, [&] {
    dashpad_case& changed = of(given);
    std::vector<std::string> settings = with_setting(changed.settings, text_of(key), text_of(value));
    take(changed,
         dashpad::input::read_case_text(changed.text, changed.file, changed.materials, settings).value());
    changed.settings = std::move(settings);
    return 1;
  });
}

int dashpad_case_set_number(dashpad_case* given, const char* key, double value, dashpad_faults** faults) {
  return guarded(faults, [&] {
    dashpad_case& changed = of(given);
    const std::string name = text_of(key);
    const CaseQuantity* const quantity = changed.quantities->find(name);
    if (quantity == nullptr) throw InputError({fault_of(name, "is not a number of this case")});
    ImpactCase impact = changed.read.impact;
    quantity->set(impact, value);
    std::vector<Fault> broken;
    for (const Violation& violation : violations(impact))
      broken.push_back(fault_of(violation.key, violation.rule));
    if (!broken.empty()) throw InputError(std::move(broken));
    changed.settings =
        with_setting(std::move(changed.settings), name, dashpad::output::toml_value(value, quantity->unit));
    changed.read.impact = std::move(impact);
    changed.toml.clear();
    return 1;
  });
}

double dashpad_case_number(const dashpad_case* given, const char* key) {
  return value_of([&] {
    const CaseQuantity* const quantity = of(given).quantities->find(text_of(key));
    return quantity == nullptr ? dashpad::no_value : quantity->get(given->read.impact);
  });
}
size_t dashpad_case_size(const dashpad_case* given) {
  return given == nullptr ? 0 : given->quantities->size();
}
const char* dashpad_case_key(const dashpad_case* given, size_t i) {
  const CaseQuantity* const quantity = number_at(given, i);
  return quantity == nullptr ? nullptr : quantity->key.c_str();
}
const char* dashpad_case_unit(const dashpad_case* given, size_t i) {
  const CaseQuantity* const quantity = number_at(given, i);
  return quantity == nullptr ? nullptr : quantity->unit.c_str();
}
const char* dashpad_case_toml(dashpad_case* given) {
  return guarded(nullptr, [&] {
    std::string& toml = of(given).toml;
    if (toml.empty()) toml = dashpad::output::case_toml(given->read.impact, given->read.options);
    return toml.c_str();
  });
}
