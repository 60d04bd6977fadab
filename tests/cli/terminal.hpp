#pragma once
/// The command at a terminal, as a person sees it.

#include <csignal>

#include <pty.h>

#include "command.hpp"

namespace dashpad::test {

/// The command on a pseudo-terminal: standard input, output and error are all of it, as for a person.
class Terminal {
 public:
  explicit Terminal(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), DASHPAD_COMMAND);
    std::vector<char*> pointers;
    for (std::string& argument : arguments) pointers.push_back(argument.data());
    pointers.push_back(nullptr);
    process_ = ::forkpty(&screen_, nullptr, nullptr, nullptr);
    if (process_ < 0) throw std::runtime_error("no pseudo-terminal");
    if (process_ == 0) {
      std::signal(SIGINT, SIG_DFL);  // a background job is started with SIGINT ignored
      ::execv(pointers[0], pointers.data());
      ::_exit(127);
    }
  }
  ~Terminal() {
    if (process_ > 0) {
      ::kill(process_, SIGKILL);
      ::waitpid(process_, nullptr, 0);
    }
    ::close(screen_);
  }
  Terminal(const Terminal&) = delete;
  Terminal& operator=(const Terminal&) = delete;

  /// Reads until the screen, from where it was last waited for, ends with `prompt`.
  testing::AssertionResult shows(const std::string& prompt) {
    while (!std::string_view{shown_}.substr(read_so_far_).ends_with(prompt))
      if (!read_some())
        return testing::AssertionFailure() << "no \"" << prompt << "\" on the screen:\n" << shown_;
    read_so_far_ = shown_.size();
    return testing::AssertionSuccess();
  }

  /// Reads until the screen has shown `text` somewhere.
  testing::AssertionResult has_shown(const std::string& text) {
    while (shown_.find(text) == std::string::npos)
      if (!read_some())
        return testing::AssertionFailure() << "no \"" << text << "\" on the screen:\n" << shown_;
    return testing::AssertionSuccess();
  }

  /// The same of a command that is stopped for most of the time: what it does takes long on any machine.
  testing::AssertionResult has_shown_when_slowed(const std::string& text) {
    for (int i = 0; i < 3000 && shown_.find(text) == std::string::npos; ++i) {
      ::kill(process_, SIGSTOP);
      ::usleep(200'000);
      ::kill(process_, SIGCONT);
      pollfd ready{screen_, POLLIN, 0};
      while (::poll(&ready, 1, 10) > 0)
        if (!read_some()) return has_shown(text);
    }
    return has_shown(text);
  }

  void type(const std::string& keys) const {
    if (::write(screen_, keys.data(), keys.size()) != static_cast<ssize_t>(keys.size()))
      throw std::runtime_error("the terminal takes no more keys");
  }

  /// Reads the rest and waits. The exit code, or 128 + signal.
  int end() {
    while (read_some()) {
    }
    int status = 0;
    while (::waitpid(process_, &status, 0) < 0 && errno == EINTR) {
    }
    process_ = 0;
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  }

  [[nodiscard]] const std::string& shown() const { return shown_; }

 private:
  /// False at the end, and when the command has been silent for so long that it hangs.
  bool read_some() {
    pollfd ready{screen_, POLLIN, 0};
    if (::poll(&ready, 1, 600'000) == 0) {
      ::kill(process_, SIGKILL);
      return false;
    }
    std::array<char, 4096> buffer{};
    const ssize_t count = ::read(screen_, buffer.data(), buffer.size());
    if (count <= 0) return false;
    shown_.append(buffer.data(), static_cast<std::size_t>(count));
    return true;
  }

  int screen_ = -1;
  pid_t process_ = 0;
  std::string shown_;
  std::size_t read_so_far_ = 0;
};

}  // namespace dashpad::test
