#include "scenarios/util/utf8.h"

#include <algorithm>
#include <iterator>

namespace touchdown::util {
namespace {

struct ByteRange {
  unsigned char first, last;

  bool Holds(char byte) const {
    const auto value = static_cast<unsigned char>(byte);
    return first <= value && value <= last;
  }
};

/// Characters of as many bytes; those after the second lie in kTail.
struct Form {
  std::size_t bytes;
  ByteRange lead, second;
};

constexpr ByteRange kTail{0x80, 0xbf};
// RFC 3629, Sec. 4.
constexpr Form kForms[] = {
    {1, {0x00, 0x7f}, {}},           {2, {0xc2, 0xdf}, kTail},        {3, {0xe0, 0xe0}, {0xa0, 0xbf}},
    {3, {0xe1, 0xec}, kTail},        {3, {0xed, 0xed}, {0x80, 0x9f}}, {3, {0xee, 0xef}, kTail},
    {4, {0xf0, 0xf0}, {0x90, 0xbf}}, {4, {0xf1, 0xf3}, kTail},        {4, {0xf4, 0xf4}, {0x80, 0x8f}}};

/// Of the character that a text begins with; 0 when it begins with none.
std::size_t BytesOfFirst(std::string_view text) {
  const auto form = std::find_if(std::begin(kForms), std::end(kForms),
                                 [&](const Form& each) { return each.lead.Holds(text.front()); });
  if (form == std::end(kForms) || text.size() < form->bytes) return 0;
  for (std::size_t i = 1; i < form->bytes; ++i) {
    if (!(i == 1 ? form->second : kTail).Holds(text[i])) return 0;
  }
  return form->bytes;
}

}  // namespace

std::size_t Utf8Bytes(std::string_view text) {
  std::size_t bytes = 0;
  while (bytes < text.size()) {
    const std::size_t more = BytesOfFirst(text.substr(bytes));
    if (more == 0) break;
    bytes += more;
  }
  return bytes;
}

}  // namespace touchdown::util
