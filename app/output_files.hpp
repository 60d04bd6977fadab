#pragma once
/// The output files of a command, each with its option, and the display of its result.

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
  std::deque<Target> options = {};  ///< one per option; no file if not given
  std::string units = {};
  output::Detail detail = output::Detail::main;
  bool force = false;

  /// The targets that were given.
  [[nodiscard]] std::vector<Target> targets() const;
  /// The file of an option; empty if not given.
  [[nodiscard]] const std::string& of(std::string_view option) const;
};

/// Adds an option for a file: "--json", or "-o,--output", found as --output.
CLI::Option* add_file(CLI::App& app, OutputFiles& files, const std::string& option, const char* help);
/// Adds --report and --markdown; returns both.
std::vector<CLI::Option*> add_documents(CLI::App& app, OutputFiles& files);

/// Adds to `errors` what forbids writing the files.
void judge_files(const OutputFiles& files, const std::vector<input::InputFile>& inputs,
                 std::vector<std::string>& errors);
/// Adds to `errors` a --picture of unknown format.
void judge_picture(const OutputFiles& files, std::vector<std::string>& errors);

using MakeDocument = std::function<output::Document(output::Pictures)>;
/// The texts of files other than documents, by option.
using Texts = std::map<std::string_view, TextOf>;

bool is_document(const Target& target);
std::string document_text(const Target& target, const MakeDocument& make);
std::string picture_text(const output::Plot& plot, const Target& target);

/// Writes the files, then shows `summary`, by default the document with the requested detail.
void publish(const OutputFiles& files, const MakeDocument& document, const Texts& texts,
             const std::optional<std::string>& summary = {});

}  // namespace dashpad::app
