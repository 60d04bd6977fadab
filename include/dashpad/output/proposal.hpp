#pragma once
/// A proposed fit for people, for programs, and as a fit file.

#include <filesystem>
#include <string>

#include "dashpad/fit/proposal.hpp"
#include "dashpad/output/document.hpp"
#include "dashpad/quantities/unit_system.hpp"

namespace dashpad::output {

/// The document of the fit, with why it was proposed, what was tried, what the tests leave open, and what to
/// measure next.
Document proposal_document(const fit::AutoFit& result, const UnitSystem& units,
                           Pictures pictures = Pictures::left_out);
/// Everything, in SI: schema/fit.schema.json with its `proposal`.
std::string proposal_json(const fit::AutoFit& result);
/// The chosen fit as a fit file, which dashpad fit reads as the same fit; the tests by their paths from
/// `folder`, where the file is to be.
std::string proposal_toml(const fit::AutoFit& result, const std::filesystem::path& folder);

}  // namespace dashpad::output
