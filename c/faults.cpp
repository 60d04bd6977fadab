// Versions and faults of include/dashpad.h.

#include "dashpad/version.hpp"
#include "handles.hpp"

namespace dashpad::c {

using input::Fault;

void tell(dashpad_faults** faults, std::vector<Fault> all) {
  if (faults == nullptr) return;
  auto told = std::make_unique<dashpad_faults>();
  told->all = std::move(all);
  for (const Fault& fault : told->all) {
    std::string& line = told->lines.emplace_back(to_string(fault));
    if (line.starts_with(": ")) line.erase(0, 2);  // of no file
  }
  for (const std::string& line : told->lines) told->text += line + '\n';
  *faults = told.release();
}

Fault fault_of(std::string key, std::string rule) {
  return {.file = "", .key = std::move(key), .value = "", .rule = std::move(rule)};
}

}  // namespace dashpad::c

int dashpad_interface(void) { return DASHPAD_INTERFACE; }
// A literal, which ends with a 0.
const char* dashpad_version(void) { return dashpad::version().data(); }

size_t dashpad_faults_size(const dashpad_faults* faults) {
  return faults == nullptr ? 0 : faults->all.size();
}
dashpad_fault dashpad_faults_at(const dashpad_faults* faults, size_t i) {
  if (i >= dashpad_faults_size(faults)) return {"", 0, "", "", "", ""};
  const dashpad::input::Fault& fault = faults->all[i];
  return {fault.file.c_str(),  fault.line,         fault.key.c_str(),
          fault.value.c_str(), fault.rule.c_str(), faults->lines[i].c_str()};
}
const char* dashpad_faults_text(const dashpad_faults* faults) {
  return faults == nullptr ? "" : faults->text.c_str();
}
void dashpad_faults_free(dashpad_faults* faults) { delete faults; }
