#include "input/iso_mme/test_files.hpp"
#include "input/spelling.hpp"

#include <algorithm>
#include <charconv>

#include <fmt/format.h>

#include "dashpad/input/fault.hpp"

namespace dashpad::input {

namespace {

using Channels = std::vector<IsoMmeChannel>;

constexpr std::size_t code_length = 16;
constexpr std::size_t place_of_dimension = 12, place_of_direction = 14;

std::string listing(const Channels& channels) {
  std::vector<std::string> all;
  for (const IsoMmeChannel& of : channels) all.push_back(fmt::format("{} ({})", of.code, of.number));
  return short_listing(all);
}

bool is_acceleration(const IsoMmeChannel& channel) {
  return channel.code.size() == code_length && channel.code.compare(place_of_dimension, 2, "AC") == 0;
}

bool matches(const std::string& code, const std::string& pattern) {
  return std::ranges::equal(code, pattern, [](char c, char wanted) { return wanted == '?' || c == wanted; });
}

/// Those that the user's words may mean: all accelerations without any words.
Channels candidates(const std::filesystem::path& file, const Channels& all, const std::string& wanted) {
  Channels found;
  const auto number = channel_number(wanted);
  const std::string pattern = upper_case(wanted);
  if (!wanted.empty() && !number && pattern.size() != code_length)
    refuse_file(
        file, fmt::format("--channel {}: a channel is a number or a code of {} characters; ? stands for any "
                          "character",
                          wanted, code_length));
  for (const IsoMmeChannel& channel : all) {
    const bool fits = wanted.empty() ? is_acceleration(channel)
                      : number       ? channel.number == *number
                                     : matches(upper_case(channel.code), pattern);
    if (fits) found.push_back(channel);
  }
  if (found.empty())
    refuse_file(file, fmt::format("{}; there are {}",
                                  wanted.empty() ? "has no channel of an acceleration (AC)"
                                                 : fmt::format("--channel {}: no such channel", wanted),
                                  listing(all)));
  return found;
}

/// X, Y and Z of one place, or two of them.
Channels directions(const std::filesystem::path& file, Channels found) {
  std::erase_if(found, [](const IsoMmeChannel& channel) {
    return channel.code.size() != code_length ||
           std::string_view("XYZ").find(channel.code[place_of_direction]) == std::string_view::npos;
  });
  const auto place = [](const IsoMmeChannel& channel) {
    std::string code = channel.code;
    code[place_of_direction] = '?';
    return code;
  };
  const auto direction = [](const IsoMmeChannel& channel) { return channel.code[place_of_direction]; };
  std::ranges::sort(found, {}, direction);
  const bool is_one_place = std::ranges::all_of(
      found, [&](const IsoMmeChannel& channel) { return place(channel) == place(found.front()); });
  const bool has_double = std::ranges::adjacent_find(found, {}, direction) != found.end();
  if (found.size() < 2)
    refuse_file(file, fmt::format("a resultant needs two or three of the directions X, Y, Z; there is {}",
                                  found.empty() ? "none" : listing(found)));
  if (!is_one_place || has_double)
    refuse_file(file, fmt::format("the resultant may be of several: {}; choose with --channel, such as {}",
                                  listing(found), place(found.front())));
  return found;
}

}  // namespace

std::optional<int> channel_number(const std::string& text) {
  int number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  const bool is_all = error == std::errc{} && end == text.data() + text.size() && text.size() < code_length;
  return is_all ? std::optional{number} : std::nullopt;
}

std::vector<IsoMmeChannel> chosen_channels(const std::filesystem::path& file, const Channels& all,
                                           const IsoMmeOptions& options) {
  Channels found = candidates(file, all, options.channel);
  if (options.resultant) return directions(file, found);
  if (found.size() > 1)
    refuse_file(file,
                fmt::format("several channels may be meant: {}; choose with --channel{}", listing(found),
                            ", or combine the directions of one place with --resultant"));
  return found;
}

}  // namespace dashpad::input
