#pragma once
/// The pages without their data, as web/build.mjs has made them. Empty texts where they were not built.

#include <string_view>

namespace dashpad::output {

extern const std::string_view page_before_data;
extern const std::string_view page_after_data;

extern const std::string_view figures_page_before_data;
extern const std::string_view figures_page_after_data;

}  // namespace dashpad::output
