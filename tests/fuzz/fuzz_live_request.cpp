// Requests to the engine of the live page, whose cases come from links and dropped files.

#include <cstdint>
#include <string>

#include "json/json_values.hpp"
#include "live/answer.hpp"
#include "reading.hpp"

using namespace dashpad;
using namespace dashpad::fuzz;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  static const live::Folders folders{.materials = DASHPAD_SOURCE_DIR "/materials",
                                     .standards = DASHPAD_SOURCE_DIR "/standards"};
  const std::string answer = live::answer(text_of(bytes, size), folders);
  const Json read = Json::parse(answer, nullptr, false);
  require(read.is_object(), "an answer is an object in JSON");
  require(
      read.contains("faults") || read.contains("title") || read.contains("case") || read.contains("foams"),
      "an answer has faults or what was asked for");
  if (const auto html = read.find("html"); html != read.end())
    for (const char* markup : {"<script", "<img", "<iframe"})
      require(html->get<std::string>().find(markup) == std::string::npos,
              "what is in a request is never markup");
  return 0;
}
