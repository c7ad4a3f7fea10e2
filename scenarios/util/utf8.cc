#include "scenarios/util/utf8.h"

#include <utf8.h>

namespace touchdown::util {

std::size_t Utf8Bytes(std::string_view text) {
  return static_cast<std::size_t>(utf8::find_invalid(text.begin(), text.end()) - text.begin());
}

}  // namespace touchdown::util
