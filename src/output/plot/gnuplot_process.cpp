#include "output/plot/gnuplot_process.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <stdexcept>
#include <system_error>
#include <utility>
#include <vector>

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fmt/format.h>

#include "output/plot/text.hpp"

namespace dashpad::output {

namespace {

[[noreturn]] void fail(int error) {
  throw std::runtime_error("could not run gnuplot: " + std::generic_category().message(error));
}

void check(int error) {
  if (error != 0) fail(error);
}

class Descriptor {
 public:
  Descriptor() = default;
  explicit Descriptor(int number) : number_(number) {}
  ~Descriptor() { close(); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }

  [[nodiscard]] int number() const { return number_; }
  [[nodiscard]] bool is_open() const { return number_ >= 0; }
  void close() {
    if (is_open()) ::close(std::exchange(number_, -1));
  }

 private:
  int number_ = -1;
};

/// Our end and the child's. Sockets rather than pipes: send() can be told not to raise SIGPIPE.
struct Channel {
  Descriptor ours, childs;

  Channel() {
    std::array<int, 2> ends{};
    if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) fail(errno);
    ours = Descriptor{ends[0]};
    childs = Descriptor{ends[1]};
  }
};

/// What gnuplot and the search for fonts need of our environment. The rest could change the picture: GNUTERM,
/// GNUPLOT_LIB and others, and the locale.
std::vector<std::string> environment() {
  std::vector<std::string> settings{"LC_ALL=C.UTF-8"};
  for (const char* name : {"PATH", "HOME", "LD_LIBRARY_PATH", "XDG_CACHE_HOME", "XDG_CONFIG_HOME",
                           "XDG_DATA_HOME", "FONTCONFIG_PATH", "FONTCONFIG_FILE"}) {
    if (const char* value = std::getenv(name)) settings.push_back(fmt::format("{}={}", name, value));
  }
  return settings;
}

std::vector<char*> pointers(std::vector<std::string>& texts) {
  std::vector<char*> result;
  for (std::string& text : texts) result.push_back(text.data());
  result.push_back(nullptr);
  return result;
}

/// How the child is started: its standard streams, and SIGPIPE as usual, whatever it does here.
class Preparation {
 public:
  Preparation(int input, int output, int errors) {
    check(::posix_spawn_file_actions_init(&actions_));
    check(::posix_spawnattr_init(&attributes_));
    check(::posix_spawn_file_actions_adddup2(&actions_, input, STDIN_FILENO));
    check(::posix_spawn_file_actions_adddup2(&actions_, output, STDOUT_FILENO));
    check(::posix_spawn_file_actions_adddup2(&actions_, errors, STDERR_FILENO));
    sigset_t signals;
    ::sigemptyset(&signals);
    ::sigaddset(&signals, SIGPIPE);
    check(::posix_spawnattr_setsigdefault(&attributes_, &signals));
    check(::posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETSIGDEF));
  }
  ~Preparation() {
    ::posix_spawn_file_actions_destroy(&actions_);
    ::posix_spawnattr_destroy(&attributes_);
  }
  Preparation(const Preparation&) = delete;
  Preparation& operator=(const Preparation&) = delete;

  [[nodiscard]] const posix_spawn_file_actions_t* actions() const { return &actions_; }
  [[nodiscard]] const posix_spawnattr_t* attributes() const { return &attributes_; }

 private:
  posix_spawn_file_actions_t actions_{};
  posix_spawnattr_t attributes_{};
};

class Child {
 public:
  explicit Child(const std::string& program) {
    Channel input, output, errors;
    const Preparation preparation{input.childs.number(), output.childs.number(), errors.childs.number()};
    // -d: neither the system's nor the user's file of settings.
    std::vector<std::string> arguments{program, "-d"};
    std::vector<std::string> settings = environment();
    const int error =
        ::posix_spawnp(&process_, program.c_str(), preparation.actions(), preparation.attributes(),
                       pointers(arguments).data(), pointers(settings).data());
    if (error == ENOENT || error == EACCES)
      throw std::runtime_error(fmt::format(
          "could not run {}, which draws the pictures: {}; install the Debian package gnuplot-nox",
          readable(program), std::generic_category().message(error)));
    check(error);
    input_ = std::move(input.ours);
    output_ = std::move(output.ours);
    errors_ = std::move(errors.ours);
  }
  ~Child() {
    input_.close();
    output_.close();
    errors_.close();
    wait();
  }
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  /// Writes and reads as the child is ready for it, until it has closed its streams: nobody waits in a
  /// circle.
  void talk(std::string_view script, std::string& output, std::string& errors) {
    while (output_.is_open() || errors_.is_open()) {
      // A number below zero is passed over.
      std::array<pollfd, 3> ready{{{.fd = input_.number(), .events = POLLOUT, .revents = 0},
                                   {.fd = output_.number(), .events = POLLIN, .revents = 0},
                                   {.fd = errors_.number(), .events = POLLIN, .revents = 0}}};
      if (::poll(ready.data(), ready.size(), -1) < 0) {
        if (errno == EINTR) continue;
        fail(errno);
      }
      if (ready[0].revents != 0) write_some(script);
      if (ready[1].revents != 0) read_some(output_, output);
      if (ready[2].revents != 0) read_some(errors_, errors);
    }
  }

  /// The status as waitpid() gives it.
  int wait() {
    while (process_ > 0 && ::waitpid(process_, &status_, 0) < 0) {
      if (errno != EINTR) break;
    }
    process_ = 0;
    return status_;
  }

 private:
  void write_some(std::string_view& script) {
    const ssize_t count = ::send(input_.number(), script.data(), script.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
    if (count < 0 && (errno == EINTR || errno == EAGAIN)) return;
    if (count >= 0) script.remove_prefix(static_cast<std::size_t>(count));
    // A child that reads no more says why on its standard error.
    if (count < 0 || script.empty()) input_.close();
  }

  static void read_some(Descriptor& from, std::string& text) {
    std::array<char, 65536> buffer;
    const ssize_t count = ::recv(from.number(), buffer.data(), buffer.size(), MSG_DONTWAIT);
    if (count > 0)
      text.append(buffer.data(), static_cast<std::size_t>(count));
    else if (count == 0 || (errno != EINTR && errno != EAGAIN))
      from.close();
  }

  pid_t process_ = 0;
  int status_ = 0;
  Descriptor input_, output_, errors_;
};

/// gnuplot's complaint in one line. It shows the place with many blanks.
std::string complaint(const std::string& errors) {
  std::string line = readable(errors);
  const auto both_blank = [](char a, char b) { return a == ' ' && b == ' '; };
  line.erase(std::unique(line.begin(), line.end(), both_blank), line.end());
  return line.empty() ? "it says nothing" : line;
}

std::string ending(int status) {
  if (WIFSIGNALED(status)) return fmt::format("signal {}", WTERMSIG(status));
  return fmt::format("exit status {}", WEXITSTATUS(status));
}

}  // namespace

std::string gnuplot_output(const std::string& program, std::string_view script) {
  Child child{program};
  std::string output, errors;
  child.talk(script, output, errors);
  const int status = child.wait();
  if (status != 0 || output.empty()) {
    throw std::runtime_error(fmt::format("{} could not draw the picture ({}): {}", readable(program),
                                         ending(status), complaint(errors)));
  }
  return output;
}

}  // namespace dashpad::output
