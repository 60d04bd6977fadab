#pragma once
/// What was measured: compression tests, out of which a card of a foam is made as by `dashpad fit --auto`,
/// and pulses, evaluated as by `dashpad pulse` and compared with a case as by `dashpad compare --pulse`.

#include "json/json_values.hpp"
#include "live/answer.hpp"

namespace dashpad::live {

/// {"files": names, "rate", "thickness", "area": texts, where the files lack them} -> {"card": TOML, "title",
/// "tone", "html": the page of the fit}, or faults. The card is missing if the fit does not converge.
Json fit_tests(const Json& request);

/// {"pulse": a table, "case", "standard"} -> {"title", "tone", "html": the page of the pulse,
/// "comparison": that beside the computed one}, or faults.
Json show_pulse(const Json& request, const Folders& folders);

}  // namespace dashpad::live
