#pragma once
/// The files that a command may be told to write, each by an option of its own, and how its answer is shown.

#include <deque>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <CLI/CLI.hpp>

#include "dashpad/output/document.hpp"
#include "dashpad/output/plot/plot.hpp"
#include "output.hpp"

namespace dashpad::app {

struct OutputFiles {
  std::deque<Target> options = {};  ///< of each the file, empty where it was not given
  std::string units = {};
  output::Detail detail = output::Detail::main;
  bool force = false;

  /// Those that were given.
  [[nodiscard]] std::vector<Target> targets() const;
  /// The file of an option that was added; empty where it was not given.
  [[nodiscard]] const std::string& of(std::string_view option) const;
};

/// Adds an option that names a file: "--json", or "-o,--output", the file of --output.
CLI::Option* add_file(CLI::App& app, OutputFiles& files, const std::string& option, const char* help);
/// Adds --report and --markdown, and returns them.
std::vector<CLI::Option*> add_documents(CLI::App& app, OutputFiles& files);

/// Tells `wrong` what forbids writing the files, as judge_targets() does.
void judge_files(const OutputFiles& files, const std::vector<input::InputFile>& inputs,
                 std::vector<std::string>& errors);
/// Tells `wrong` of a --picture whose name has the ending of no format.
void judge_picture(const OutputFiles& files, std::vector<std::string>& errors);

/// A document, with pictures or without.
using MakeDocument = std::function<output::Document(output::Pictures)>;
/// What goes into the files that are no documents, by their options.
using Texts = std::map<std::string_view, TextOf>;

bool is_document(const Target& target);
std::string document_text(const Target& target, const MakeDocument& make);
/// The picture file of that name.
std::string picture_text(const output::Plot& plot, const Target& target);

/// Writes the files, then shows `summary`; without one the document with the detail asked for.
void publish(const OutputFiles& files, const MakeDocument& document, const Texts& texts,
             const std::optional<std::string>& summary = {});

}  // namespace dashpad::app
