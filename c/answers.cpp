// Answers of include/dashpad.h.

#include <cstring>

#include "handles.hpp"
#include "input/toml_tree.hpp"
#include "json/json_values.hpp"
#include "live/answer.hpp"
#include "live/case_tables.hpp"
#include "live/request.hpp"

using namespace dashpad::c;

namespace {

/// A request with a case and its changes; what is no request stays as it is.
std::string about(const dashpad_case& given, const std::string& request) {
  dashpad::Json asked = dashpad::Json::parse(request, nullptr, false);
  if (!asked.is_object()) return request;
  if (given.is_file)
    asked["file"] = given.file;
  else
    asked["case"] =
        dashpad::live::tables_of(dashpad::input::read_toml_text(given.file, given.text).value().root);
  asked["set"] = given.settings;
  return asked.dump();
}

}  // namespace

char* dashpad_answer(const char* request, const dashpad_case* given, const char* materials,
                     const char* standards) {
  return guarded(nullptr, [&]() -> char* {
    std::string answer;
    try {
      answer = given == nullptr
                   ? dashpad::live::answer(text_of(request), {text_of(materials), text_of(standards)})
                   : dashpad::live::answer(about(*given, text_of(request)),
                                           {given->materials, text_of(standards)});
    } catch (const std::exception& error) {
      answer = dashpad::live::fault_json("", error.what()).dump();
    }
    auto text = std::make_unique<char[]>(answer.size() + 1);
    std::memcpy(text.get(), answer.c_str(), answer.size() + 1);
    return text.release();
  });
}
void dashpad_text_free(char* text) { delete[] text; }
