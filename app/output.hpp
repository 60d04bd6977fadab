#pragma once
/// Output: result files, which are complete or absent, never over others unasked; the standard streams.

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "dashpad/input/reading.hpp"
#include "system.hpp"

namespace dashpad::app {

/// Call first. Turns broken pipes and file size limits into error codes instead of signals, and keeps later
/// files from taking the place of a closed standard stream.
void prepare_streams();

/// Writes all of `text`. Returns 0 or the system's error number.
int write_all(int descriptor, std::string_view text);

/// Writes text for people to standard output, without control characters. A closed pipe is no error. Throws
/// std::runtime_error if writing fails, as on a full disk.
void write_output(std::string_view text);

/// Writes data for programs to standard output, unchanged; on a terminal like write_output().
void write_result(std::string_view text);

/// Writes text for people to standard error, if possible.
void write_error(std::string_view text);

/// An output file as given on the command line: "--json" and its FILE.
struct Target {
  std::string option;
  std::string file;
  [[nodiscard]] bool is_standard_output() const { return file == "-"; }
};

/// Adds to `errors` what forbids writing to the targets: an existing file (without force), a folder that is
/// missing or not writable, equal targets, a target of redirected standard output or error, an input.
void judge_targets(const std::vector<Target>& targets, const std::vector<input::InputFile>& inputs,
                   bool force, std::vector<std::string>& errors);

/// Fills an existing file, for results too large for memory.
using WriteFile = std::function<void(const std::filesystem::path&)>;

/// A result to be published. The constructor writes it beside the target under another name and syncs it to
/// the disk; publish() renames it in one step, without force only if the name is still free. Destroyed before
/// that, it leaves nothing. With force, links are followed. Devices and pipes are written by publish(). Both
/// throw std::runtime_error with the file and the system's reason, and what `write` throws.
class PendingFile {
 public:
  PendingFile(const Target& target, std::string_view text, bool force);
  PendingFile(const Target& target, const WriteFile& write, bool force);
  ~PendingFile();
  PendingFile(PendingFile&& other) noexcept;
  PendingFile(const PendingFile&) = delete;
  PendingFile& operator=(const PendingFile&) = delete;
  PendingFile& operator=(PendingFile&&) = delete;

  void publish();

 private:
  PendingFile(const Target& target, bool force);
  void settle(int problem);

  std::string name_;              ///< for messages
  std::filesystem::path target_;  ///< with links followed
  std::filesystem::path draft_;   ///< empty after publishing, and for a device
  int descriptor_ = -1;           ///< of the draft, while open
  std::function<void()> write_device_ = {};
  bool force_ = false;
};

using TextOf = std::function<std::string(const Target&)>;

/// Writes the files among the targets, all or none as far as possible. Returns the text for standard output,
/// if that is a target. Throws as PendingFile does.
std::string publish(const std::vector<Target>& targets, bool force, const TextOf& text_of);

/// The same; then writes `summary` to standard output, or to standard error if standard output is a target.
void publish(const std::vector<Target>& targets, bool force, const TextOf& text_of, std::string_view summary);

}  // namespace dashpad::app
