#pragma once
/// The page without its data, as web/build.mjs has made it. Empty texts where it was not built.

#include <string_view>

namespace dashpad {

extern const std::string_view page_before_data;
extern const std::string_view page_after_data;

}  // namespace dashpad
