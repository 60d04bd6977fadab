#pragma once
/// What the command shows and writes, for a host that has the files.

#include <functional>
#include <string>

#include "dashpad/output/document.hpp"
#include "json/json_values.hpp"

namespace dashpad::live {

struct Writers {
  std::function<output::Document(output::Pictures)> document;
  std::function<std::string()> json = {};  ///< may be empty
  std::function<std::string()> page = {};  ///< the page of the document, if empty
};

/// The texts that "write" of a request lists: "text" and "all" of the terminal, "json", "page", "markdown".
/// An object with each by its name.
Json written(const Json& request, const Writers& writers);

}  // namespace dashpad::live
