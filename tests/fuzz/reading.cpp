#include "reading.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "quantities/text.hpp"
#include "shared/temporary_folder.hpp"

namespace dashpad::fuzz {

namespace fs = std::filesystem;

namespace {

const test::TemporaryFolder& own() {
  static const test::TemporaryFolder folder;
  return folder;
}

}  // namespace

const fs::path& folder() { return own().path(); }

fs::path write(const fs::path& name, std::string_view bytes) { return own().write(name, bytes); }

void require(bool holds, const char* rule) {
  if (holds) return;
  std::fprintf(stderr, "BROKEN RULE: %s\n", rule);
  std::abort();
}

void require_finite(const std::vector<double>& values, const char* rule) {
  require(std::ranges::all_of(values, [](double value) { return std::isfinite(value); }), rule);
}

void require_increasing(const std::vector<double>& values, const char* rule) {
  require_finite(values, rule);
  require(std::ranges::adjacent_find(values, std::greater_equal<>{}) == values.end(), rule);
}

void require_plain_text(std::string_view text, const char* rule) {
  while (!text.empty()) {
    const auto end = std::min(text.find('\n'), text.size());
    require(one_line(text.substr(0, end)) == text.substr(0, end), rule);
    text.remove_prefix(std::min(end + 1, text.size()));
  }
}

void require_sound(const std::vector<input::Fault>& faults) {
  for (const input::Fault& fault : faults) {
    require(!fault.file.empty(), "a fault names its file");
    require(fault.line >= 0, "a fault has a line, or 0");
    require(!fault.rule.empty(), "a fault names a rule");
    require_plain_text(to_string(fault), "a fault is plain text");
  }
}

void require_sound(const input::InputError& refusal) {
  require(!refusal.faults().empty(), "a refusal has a fault");
  require_sound(refusal.faults());
  require_plain_text(refusal.what(), "a refusal is plain text");
}

}  // namespace dashpad::fuzz
