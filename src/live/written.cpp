#include "live/written.hpp"

#include "live/request.hpp"

namespace dashpad::live {

Json written(const Json& request, const Writers& writers) {
  Json all = Json::object();
  for (const std::string& name : texts_of(request, "write")) {
    const auto document = [&](output::Pictures pictures) { return writers.document(pictures); };
    if (name == "text" || name == "all")
      all[name] = output::to_terminal(document(output::Pictures::left_out),
                                      name == "all" ? output::Detail::all : output::Detail::main);
    if (name == "json" && writers.json) all[name] = writers.json();
    if (name == "page")
      all[name] = writers.page ? writers.page() : output::to_html(document(output::Pictures::drawn));
    if (name == "markdown") all[name] = output::to_markdown(document(output::Pictures::left_out));
  }
  return all;
}

}  // namespace dashpad::live
