#pragma once
/// The files that say it all to people: a page and Markdown.

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "dashpad/output/document.hpp"
#include "output.hpp"

namespace dashpad::app {

struct DocumentFiles {
  std::optional<std::string> page;      ///< --report
  std::optional<std::string> markdown;  ///< --markdown
};

/// Adds --report and --markdown, and returns them.
std::vector<CLI::Option*> add_documents(CLI::App& app, DocumentFiles& files);

bool is_document(const Target& target);

/// What goes into the target, of a document that is made with pictures or without.
std::string document_text(const Target& target,
                          const std::function<output::Document(output::Pictures)>& make);

}  // namespace dashpad::app
