#include "output/svg/text.hpp"

#include "quantities/text.hpp"

namespace dashpad::output {

namespace {

struct Character {
  std::size_t bytes = 1;
  char32_t code = 0;
  bool is_valid = false;
};

/// The character at the beginning of `text`, which is not empty. As in RFC 3629: no overlong forms, no
/// surrogates, nothing above U+10FFFF.
Character first_character(std::string_view text) {
  const auto byte = [&](std::size_t place) { return static_cast<unsigned char>(text[place]); };
  const unsigned char lead = byte(0);
  if (lead < 0x80) return {.bytes = 1, .code = lead, .is_valid = true};
  const std::size_t bytes = lead >= 0xf0 ? 4 : lead >= 0xe0 ? 3 : 2;
  if (lead < 0xc2 || lead > 0xf4 || text.size() < bytes) return {};
  char32_t code = lead & (0x7fU >> bytes);
  for (std::size_t place = 1; place < bytes; ++place) {
    if ((byte(place) & 0xc0) != 0x80) return {};
    code = (code << 6) | (byte(place) & 0x3fU);
  }
  const bool is_overlong = code < (bytes == 4 ? 0x10000U : bytes == 3 ? 0x800U : 0x80U);
  const bool is_surrogate = code >= 0xd800 && code <= 0xdfff;
  if (is_overlong || is_surrogate || code > 0x10ffff) return {};
  return {.bytes = bytes, .code = code, .is_valid = true};
}

bool is_control(char32_t code) {
  return code < 0x20 || (code >= 0x7f && code < 0xa0) || code == 0x2028 || code == 0x2029;
}

/// U+FFFE and U+FFFF, which XML forbids.
bool is_no_character(char32_t code) { return code == 0xfffe || code == 0xffff; }

/// Bytes of the first `count` characters of valid UTF-8.
std::size_t bytes_of(std::string_view text, std::size_t count) {
  std::size_t bytes = 0;
  for (; count > 0 && bytes < text.size(); --count) bytes += first_character(text.substr(bytes)).bytes;
  return bytes;
}

}  // namespace

std::string readable(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const Character character = first_character(text);
    if (!character.is_valid || is_no_character(character.code))
      result += "\xef\xbf\xbd";
    else if (is_control(character.code))
      result += ' ';
    else
      result += text.substr(0, character.bytes);
    text.remove_prefix(character.bytes);
  }
  return result;
}

std::string shortened(std::string_view text, std::size_t length) {
  std::string result = readable(text);
  if (width_of(result) <= length) return result;
  return result.substr(0, bytes_of(result, length - 1)) + "…";
}

}  // namespace dashpad::output
