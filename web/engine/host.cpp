// The engine of the live page, and that of the command in node, as a WebAssembly module: src/live/answer.hpp and
// src/live/command.hpp for a host that is no C++. It needs no import but refuse() and a few of WASI, which may do
// nothing.
//
// A request is written to the memory that allocate() gives; answer() takes it and leaves the answer at the
// place that it returns, result_size() bytes long, until the next request. Exceptions end the program, since
// Debian's C++ library for WebAssembly has none: refuse() is told why and must throw, and the module is to be
// made anew.

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <map>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "dashpad/input/fault.hpp"
#include "fit/determine.hpp"
#include "input/disk.hpp"
#include "input/measurement/measurement_text.hpp"
#include "live/answer.hpp"
#include "live/command.hpp"
#include "margin/evaluation.hpp"

// Of a live page, or of the command in node.
#ifndef ANSWER
#define ANSWER dashpad::live::answer
#endif

#define EXPORTED(name) extern "C" __attribute__((export_name(#name)))

extern "C" __attribute__((import_module("host"), import_name("refuse"))) void refuse(const char* text,
                                                                                      std::size_t size);

extern "C" {
void* __cxa_allocate_exception(std::size_t size) noexcept { return std::malloc(size); }
// Everything that Dashpad and its libraries throw is a std::exception first.
void __cxa_throw(void* thrown, void* /*type*/, void (* /*destroy*/)(void*)) {
  const std::string_view text = static_cast<const std::exception*>(thrown)->what();
  refuse(text.data(), text.size());
  std::abort();
}
// The only thread does not end.
int __cxa_thread_atexit(void (* /*destroy*/)(void*), void* /*object*/, void* /*module*/) { return 0; }
// Debian's builtins of the compiler guard their stack, and its C library has no guard.
std::uintptr_t __stack_chk_guard = 0x5bd1e995;
void __stack_chk_fail() { std::abort(); }
}

namespace dashpad {
/// The cards and standards that come with the program, by path. Made by ./do wasm.
std::span<const std::pair<const char*, std::string_view>> shipped_files();
}  // namespace dashpad

namespace {

/// Cards, standards and what the host adds, by path.
std::map<std::filesystem::path, std::string>& files() {
  static std::map<std::filesystem::path, std::string> all = [] {
    std::map<std::filesystem::path, std::string> shipped;
    for (const auto& [file, text] : dashpad::shipped_files()) shipped.emplace(file, text);
    return shipped;
  }();
  return all;
}

/// Why files and folders that the host has looked for cannot be read, by path.
std::map<std::filesystem::path, std::string>& refused() {
  static std::map<std::filesystem::path, std::string> all;
  return all;
}

/// What was looked for in vain; the host may add these files and ask again.
std::set<std::filesystem::path>& missing() {
  static std::set<std::filesystem::path> all;
  return all;
}

std::string result;

}  // namespace

namespace dashpad::input {

bool is_there(const std::filesystem::path& file) {
  if (files().contains(file) || refused().contains(file)) return true;
  missing().insert(file);
  return false;
}
bool is_link(const std::filesystem::path& /*file*/) { return false; }
bool is_same_file(const std::filesystem::path& file, const std::filesystem::path& other) { return file == other; }

Reading<std::string> content_of(const std::filesystem::path& file, std::size_t /*most*/) {
  const auto found = files().find(file);
  if (found != files().end()) return found->second;
  if (const auto why = refused().find(file); why != refused().end()) return fault_of_file(file, why->second);
  missing().insert(file);
  return fault_of_file(file, "no such file");
}

std::string read_measurement(const std::filesystem::path& file, std::size_t /*most*/) {
  const auto found = files().find(file);
  if (found == files().end()) refuse_file(file.string(), "no such file");
  return found->second;
}

Reading<std::vector<std::filesystem::path>> toml_files(const std::filesystem::path& folder,
                                                       std::string_view /*content*/) {
  if (const auto why = refused().find(folder); why != refused().end()) return fault_of_file(folder, why->second);
  std::vector<std::filesystem::path> all;
  for (const auto& [file, text] : files())
    if (file.parent_path() == folder && file.extension() == ".toml") all.push_back(file);
  return all;
}

}  // namespace dashpad::input

// No page asks for a probability, which takes thousands of impacts.
namespace dashpad::margin {
Draws draws_at(const Question& /*question*/, double /*value*/) { std::abort(); }
std::vector<Contributor> contributors_of(const Question& /*question*/, double /*value*/, const Draws& /*draws*/) {
  std::abort();
}
Place place_of(const Question& /*question*/, double /*value*/, const Draws& /*draws*/) { std::abort(); }
}  // namespace dashpad::margin

// What a fit has finished is kept nowhere.
namespace dashpad::fit {
Session::Session(const Fit& /*fit*/, const RunOptions& options) : options_(options) {}
void Session::throw_if_stopped() const {}
void Session::begin(const char* /*what*/, std::size_t /*pieces*/) {}
Minimum Session::piece(const std::string& /*name*/, const std::function<Minimum()>& compute) { return compute(); }
ProfileEnd Session::piece(const std::string& /*name*/, const std::function<ProfileEnd()>& compute) { return compute(); }
}  // namespace dashpad::fit

EXPORTED(allocate) void* allocate(std::size_t size) { return std::malloc(size == 0 ? 1 : size); }

/// Takes the memory of both: a path and its text.
EXPORTED(add_file)
void add_file(char* name, std::size_t name_size, char* text, std::size_t text_size) {
  files()[std::string(name, name_size)] = std::string(text, text_size);
  std::free(name);
  std::free(text);
}

/// The same: a path, and why it cannot be read.
EXPORTED(refuse_file)
void refuse_file(char* name, std::size_t name_size, char* why, std::size_t why_size) {
  refused()[std::string(name, name_size)] = std::string(why, why_size);
  std::free(name);
  std::free(why);
}

/// The paths that answers since the last call looked for in vain, a line each, as result of result_size().
EXPORTED(missing_files) const char* missing_files() {
  result.clear();
  for (const std::filesystem::path& file : missing()) result += file.string() + "\n";
  missing().clear();
  return result.data();
}

EXPORTED(answer) const char* answer(char* request, std::size_t size) {
  const std::string text(request, size);
  std::free(request);
  result = ANSWER(text, {"materials", "standards"});
  return result.data();
}

EXPORTED(result_size) std::size_t result_size() { return result.size(); }
