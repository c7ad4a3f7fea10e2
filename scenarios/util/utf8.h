#pragma once

#include <cstddef>
#include <string_view>

namespace touchdown::util {

/// Length in bytes of the longest prefix of a text that is valid UTF-8 (RFC 3629).
std::size_t Utf8Bytes(std::string_view text);

}  // namespace touchdown::util
