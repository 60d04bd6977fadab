#include "documents.hpp"

namespace dashpad::app {

std::vector<CLI::Option*> add_documents(CLI::App& app, DocumentFiles& files) {
  return {app.add_option("--report", files.page, "Write a page to look at in a browser, as one HTML file")
              ->type_name("FILE"),
          app.add_option("--markdown", files.markdown,
                         "Write what the page says, without pictures, as Markdown (- for standard output)")
              ->type_name("FILE")};
}

bool is_document(const Target& target) {
  return target.option == "--report" || target.option == "--markdown";
}

std::string document_text(const Target& target,
                          const std::function<output::Document(output::Pictures)>& make) {
  return target.option == "--markdown" ? output::to_markdown(make(output::Pictures::left_out))
                                       : output::to_html(make(output::Pictures::drawn));
}

}  // namespace dashpad::app
