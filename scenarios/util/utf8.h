#pragma once

#include <cstddef>
#include <string_view>

namespace touchdown::util {

/// How many of a text's bytes are UTF-8 (RFC 3629), from its start to the first character that is not.
std::size_t Utf8Bytes(std::string_view text);

}  // namespace touchdown::util
