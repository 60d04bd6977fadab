#include "output_files.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace dashpad::app {

std::vector<Target> OutputFiles::targets() const {
  std::vector<Target> given;
  for (const Target& option : options)
    if (!option.file.empty()) given.push_back(option);
  return given;
}

const std::string& OutputFiles::of(std::string_view option) const {
  return std::ranges::find(options, option, &Target::option)->file;
}

CLI::Option* add_file(CLI::App& app, OutputFiles& files, const std::string& option, const char* help) {
  files.options.push_back({option.substr(option.rfind(',') + 1), ""});
  return app.add_option(option, files.options.back().file, help)->type_name("FILE");
}

std::vector<CLI::Option*> add_documents(CLI::App& app, OutputFiles& files) {
  return {add_file(app, files, "--report", "Write a page for a web browser, as a single HTML file"),
          add_file(app, files, "--markdown",
                   "Write the text of the page as Markdown, without pictures (- for standard output)")};
}

void judge_files(const OutputFiles& files, const std::vector<input::InputFile>& inputs,
                 std::vector<std::string>& errors) {
  judge_targets(files.targets(), inputs, files.force, errors);
}

void judge_picture(const OutputFiles& files, std::vector<std::string>& errors) {
  if (const std::string& file = files.of("--picture"); !file.empty() && !output::picture_format(file))
    errors.push_back(fmt::format("--picture {}: must end in .svg, .png or .pdf", file));
}

bool is_document(const Target& target) {
  return target.option == "--report" || target.option == "--markdown";
}

std::string document_text(const Target& target, const MakeDocument& make) {
  return target.option == "--markdown" ? output::to_markdown(make(output::Pictures::left_out))
                                       : output::to_html(make(output::Pictures::drawn));
}

std::string picture_text(const output::Plot& plot, const Target& target) {
  return output::picture(plot, *output::picture_format(target.file));
}

void publish(const OutputFiles& files, const MakeDocument& document, const Texts& texts,
             const std::optional<std::string>& summary) {
  const auto text_of = [&](const Target& target) {
    return is_document(target) ? document_text(target, document) : texts.at(target.option)(target);
  };
  publish(files.targets(), files.force, text_of,
          summary ? *summary : output::to_terminal(document(output::Pictures::left_out), files.detail));
}

}  // namespace dashpad::app
