#pragma once
/// Result files, complete or not there at all, and never in the place of another file unasked; standard
/// output and standard error, with every failure noticed.

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "dashpad/input/reading.hpp"

namespace dashpad::app {

/// Call first. A reader that goes away or a limit on file sizes becomes an error code instead of a signal,
/// and no file that is opened later can take the place of a standard stream that is closed.
void prepare_streams();

/// Writes all of `text` to a file descriptor. Returns 0, or the error number of the system.
int write_all(int descriptor, std::string_view text);

/// What is for people, to standard output, without control characters. A reader that has gone away has seen
/// enough: no error. Throws std::runtime_error where the text cannot be written, on a full disk for example.
void write_output(std::string_view text);

/// What is for programs, to standard output, as it is; a terminal gets it as write_output() would give it.
void write_result(std::string_view text);

/// What is for people, to standard error, where possible.
void write_error(std::string_view text);

/// A file that the user wants written, as given: "--json" and its FILE.
struct Target {
  std::string option;
  std::string file;
  [[nodiscard]] bool is_standard_output() const { return file == "-"; }
};

/// Whether a path is a device or a pipe, which is written into as it is.
bool is_device(const std::filesystem::path& path);

/// Tells `wrong` what forbids writing to the targets, seen before the run, a line each: a file that exists
/// (without force), a folder that is missing or closed to us, two targets that are one, standard output or
/// standard error redirected to a target, a target that is one of the files that the command read.
void judge_targets(const std::vector<Target>& targets, const std::vector<input::InputFile>& inputs,
                   bool force, std::vector<std::string>& errors);

/// Fills the file of that name, which is there: for results too large for memory.
using WriteFile = std::function<void(const std::filesystem::path&)>;

/// A result on its way to its target. The constructor writes it beside the target under another name and
/// makes sure that it is on the disk; publish() gives it its name in one step, without force only if that
/// name is still free. Dropped before that, it leaves nothing. With force, a link is followed. A device or
/// pipe is written to by publish(), as it is. Both throw std::runtime_error that names the file and the
/// system's reason, and what `write` throws.
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
  std::filesystem::path target_;  ///< links followed
  std::filesystem::path draft_;   ///< empty once published, or for a device
  int descriptor_ = -1;           ///< of the draft while it is being written
  std::function<void()> write_device_ = {};
  bool force_ = false;
};

/// The text of a target.
using TextOf = std::function<std::string(const Target&)>;

/// Writes the files among the targets, all of them or none as far as the disk can tell. Returns the text of
/// the target that is standard output, empty if there is none. Throws as PendingFile does.
std::string publish(const std::vector<Target>& targets, bool force, const TextOf& text_of);

/// publish(), then what is for people: to standard output, or to standard error where that is for a target.
void publish(const std::vector<Target>& targets, bool force, const TextOf& text_of, std::string_view summary);

}  // namespace dashpad::app
