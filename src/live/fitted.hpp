#pragma once
/// A card of a foam out of tables of compression tests, as `dashpad fit --auto` makes it.

#include "json/json_values.hpp"

namespace dashpad::live {

/// {"files": names, "rate", "thickness", "area": texts, where the files lack them} -> {"card": TOML, "title",
/// "tone", "html": the page of the fit}, or faults. The card is missing if the fit does not converge.
Json fit_tests(const Json& request);

}  // namespace dashpad::live
