#pragma once
/// Tables in a text of Markdown, between lines "<!-- results: NAME -->" and "<!-- end -->".

#include <map>
#include <string>

#include "dashpad/output/document.hpp"

namespace dashpad::bench {

std::string markdown(const output::Table& table);

/// The text with what stands between the marks replaced. Throws std::runtime_error for a name that `blocks`
/// lacks, for one of `blocks` that the text lacks, and for a mark without an end.
std::string with_blocks(const std::string& text, const std::map<std::string, std::string>& blocks);

}  // namespace dashpad::bench
