// What app/system.hpp asks of the system, and the beginning of the streams.

#include "system.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include <fcntl.h>
#include <io.h>

#define WIN32_LEAN_AND_MEAN
#include <windows.h>

#include "output.hpp"

/// Of the C library: the words of the command line in UTF-16. shell32 has them too, but takes long to load.
extern "C" int __cdecl __wgetmainargs(int* count, wchar_t*** words, wchar_t*** variables, int expand,
                                      int* mode);

namespace dashpad::app {

namespace fs = std::filesystem;

namespace {

/// Lower case, as far as names of devices and endings need it.
std::string small(std::string text) {
  std::ranges::transform(text, text.begin(), [](char c) { return 'A' <= c && c <= 'Z' ? char(c + 32) : c; });
  return text;
}

/// Names of devices, in any folder and with any ending.
bool is_name_of_device(std::string_view stem) {
  constexpr std::array<std::string_view, 6> names{"con", "prn", "aux", "nul", "conin$", "conout$"};
  const bool has_number = stem.size() == 4 && stem[3] >= '1' && stem[3] <= '9';
  return std::ranges::find(names, stem) != names.end() ||
         (has_number && (stem.starts_with("com") || stem.starts_with("lpt")));
}

class Handle {
 public:
  explicit Handle(HANDLE handle) : handle_(handle) {}
  ~Handle() {
    if (handle_ != INVALID_HANDLE_VALUE) CloseHandle(handle_);
  }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  [[nodiscard]] HANDLE get() const { return handle_; }

 private:
  HANDLE handle_;
};

/// What no two files have alike; nothing for what is no file.
std::optional<std::array<DWORD, 3>> number_of(HANDLE file) {
  BY_HANDLE_FILE_INFORMATION facts;
  if (GetFileType(file) != FILE_TYPE_DISK || GetFileInformationByHandle(file, &facts) == 0) return {};
  return std::array{facts.dwVolumeSerialNumber, facts.nFileIndexHigh, facts.nFileIndexLow};
}

}  // namespace

std::span<char*> arguments_in_utf8(int /*count*/, char** /*arguments*/) {
  static std::vector<std::string> texts;
  static std::vector<char*> given;
  int count = 0;
  wchar_t **words = nullptr, **variables = nullptr;
  int mode = 0;  // of memory: as usual
  constexpr int without_wildcards = 0;
  if (__wgetmainargs(&count, &words, &variables, without_wildcards, &mode) != 0) count = 0;
  for (int i = 0; i < count; ++i) texts.push_back(fs::path(words[i]).string());
  for (std::string& text : texts) given.push_back(text.data());
  given.push_back(nullptr);
  return {given.data(), given.size() - 1};
}

std::string environment(const char* variable) {
  const wchar_t* const value = _wgetenv(fs::path(variable).c_str());
  return value == nullptr ? "" : fs::path(value).string();
}

fs::path running_executable() {
  constexpr DWORD longest_name = 32768;
  std::wstring name(longest_name, L'\0');
  name.resize(GetModuleFileNameW(nullptr, name.data(), longest_name));
  return name;
}

const char* stream_into(const fs::path& file) {
  const Handle opened(CreateFileW(file.c_str(), 0, FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE,
                                  nullptr, OPEN_EXISTING, 0, nullptr));
  if (opened.get() == INVALID_HANDLE_VALUE) return nullptr;
  const auto number = number_of(opened.get());
  if (number && number == number_of(GetStdHandle(STD_OUTPUT_HANDLE))) return "standard output";
  if (number && number == number_of(GetStdHandle(STD_ERROR_HANDLE))) return "standard error";
  return nullptr;
}

bool is_device(const fs::path& path) {
  return path.native().starts_with(L"\\\\.\\") || is_name_of_device(small(path.stem().string()));
}

std::string missing_for(const fs::path& file) {
  const std::string ending = small(file.extension().string());
  if (ending == ".png" || ending == ".pdf")
    return "PNG and PDF are not in dashpad for Windows, which draws SVG; the page of --report has all "
           "pictures";
  return ending == ".zip" ? "archives are not in dashpad for Windows" : "";
}

void prepare_streams() {
  // The same bytes as elsewhere: no line end becomes two characters.
  for (const int stream : {0, 1, 2}) _setmode(stream, _O_BINARY);
  // Text is UTF-8. The code page belongs to the window and outlives the program.
  static const UINT code_page_before = GetConsoleOutputCP();
  if (code_page_before == 0 || code_page_before == CP_UTF8) return;
  SetConsoleOutputCP(CP_UTF8);
  std::atexit([] { SetConsoleOutputCP(code_page_before); });
}

}  // namespace dashpad::app
