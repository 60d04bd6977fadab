#pragma once
/// A card of a foam out of tables of compression tests, as `dashpad fit --auto` makes it.

#include "json/json_values.hpp"

namespace dashpad::live {

/// {"files": names, "rates": 1/s each} -> {"card": TOML, "title", "tone", "html": the page of the fit}. If
/// nothing is missing but rates, {"rates": how many}.
Json fit_tests(const Json& request);

}  // namespace dashpad::live
