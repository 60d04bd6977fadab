#pragma once
/// Runs the built command as a user does, in a folder of its own.

#include <array>
#include <cerrno>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <gtest/gtest.h>

#include "shared/temporary_folder.hpp"

namespace dashpad::test {

namespace fs = std::filesystem;

/// The examples' folder, with its slash, and the example with the 9-parameter law.
inline const std::string examples = DASHPAD_SOURCE_DIR "/examples/";
inline const std::string nine = examples + "dashboard-20mph.toml";

struct Outcome {
  int exit_code = -1;  ///< 128 + signal if it was killed
  std::string out;
  std::string err;
};

/// Runs a program with its arguments, with nothing on standard input, and waits for its end.
inline Outcome run_program(std::vector<std::string> arguments) {
  std::array<int, 2> out{}, err{};
  if (::pipe2(out.data(), O_CLOEXEC) != 0 || ::pipe2(err.data(), O_CLOEXEC) != 0)
    throw std::runtime_error("no pipe");
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_adddup2(&actions, out[1], STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, err[1], STDERR_FILENO);
  std::vector<char*> pointers;
  for (std::string& argument : arguments) pointers.push_back(argument.data());
  pointers.push_back(nullptr);
  pid_t process = 0;
  const int error = ::posix_spawn(&process, pointers[0], &actions, nullptr, pointers.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  ::close(out[1]);
  ::close(err[1]);
  if (error != 0) throw std::runtime_error("could not start " + arguments[0]);

  Outcome outcome;
  std::array<pollfd, 2> streams{pollfd{out[0], POLLIN, 0}, pollfd{err[0], POLLIN, 0}};
  const std::array<std::string*, 2> texts{&outcome.out, &outcome.err};
  std::array<char, 65536> buffer{};
  for (int open = 2; open > 0;) {
    if (::poll(streams.data(), streams.size(), -1) < 0 && errno != EINTR) break;
    for (std::size_t i = 0; i < streams.size(); ++i) {
      if (streams[i].fd < 0 || streams[i].revents == 0) continue;
      const ssize_t count = ::read(streams[i].fd, buffer.data(), buffer.size());
      if (count > 0) {
        texts[i]->append(buffer.data(), static_cast<std::size_t>(count));
      } else {
        ::close(streams[i].fd);
        streams[i].fd = -1;
        --open;
      }
    }
  }
  int status = 0;
  while (::waitpid(process, &status, 0) < 0 && errno == EINTR) {
  }
  outcome.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return outcome;
}

/// A shell script in which $DASHPAD is the command.
inline Outcome shell(const std::string& script) {
  // Also where the tests themselves were started in the background, with signals ignored for good.
  return run_program({"/usr/bin/env", "--default-signal=HUP,INT,TERM", "/bin/sh", "-c",
                      "DASHPAD='" DASHPAD_COMMAND "'\n" + script});
}

/// A line of a script that waits until a command of the shell succeeds, for ten minutes at most: a machine
/// may be slow, and what hangs has to end.
inline std::string until(const std::string& condition) {
  return "for i in $(seq 12000); do " + condition + " && break; sleep 0.05; done\n";
}

/// The same, and meanwhile the command $! is stopped for most of the time: its work takes long on any
/// machine.
inline std::string slowed_until(const std::string& condition) {
  return "for i in $(seq 3000); do kill -STOP $!; " + condition +
         " && break; sleep 0.2; kill -CONT $!; sleep 0.01; done; kill -CONT $!\n";
}

/// A command of the shell that succeeds once a study has written rows: soon, however many there are to come.
inline std::string has_rows(const std::string& store) {
  return "$DASHPAD study export " + store + " --csv - 2> /dev/null | head -n 2 | tail -n +2 | grep -q .";
}

/// What a run says that was over in less time, s, as the clock of this test has it. It is repeated until one
/// was, for a machine may be busy; of one that never is so fast nothing can be said.
template <class Run>
auto said_within(double time, Run run) -> std::optional<decltype(run())> {
  for (int i = 0; i < 100; ++i) {
    const auto begin = std::chrono::steady_clock::now();
    auto said = run();
    if (std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count() < time) return said;
  }
  return std::nullopt;
}

inline Outcome dashpad(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), DASHPAD_COMMAND);
  return run_program(std::move(arguments));
}

inline std::string read_file(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

inline void write_file(const fs::path& path, const std::string& text) {
  std::ofstream file(path, std::ios::binary);
  file << text;
  ASSERT_TRUE(file.flush()) << path;
}

/// A case that is solved in no time: an elastic pad on an elastic support.
inline std::string elastic_case() {
  return R"(title = "Elastic"
[impactor]
mass = "5 kg"
radius = "80 mm"
speed = "3 m/s"
[pad]
thickness = "50 mm"
law = "elastic"
[pad.parameters]
modulus = "300 kPa"
[support]
type = "linear"
stiffness = "100 N/mm"
)";
}

/// `text` with the first `old` replaced; fails the test if there is none.
inline std::string with(std::string text, const std::string& old, const std::string& replacement) {
  const auto place = text.find(old);
  if (place == std::string::npos) throw std::invalid_argument("no \"" + old + "\" in the text");
  return text.replace(place, old.size(), replacement);
}

/// A test of the command: a folder, and in it case.toml, which is all right.
class CommandTest : public testing::Test {
 protected:
  void SetUp() override { write_file(file("case.toml"), elastic_case()); }

  [[nodiscard]] std::string file(const std::string& name) const { return (folder_.path() / name).string(); }
  [[nodiscard]] std::string case_file() const { return file("case.toml"); }

  /// Names in the folder beside case.toml.
  [[nodiscard]] std::vector<std::string> other_files() const {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder_.path()))
      if (entry.path().filename() != "case.toml") names.push_back(entry.path().filename().string());
    return names;
  }

 private:
  TemporaryFolder folder_;
};

}  // namespace dashpad::test
