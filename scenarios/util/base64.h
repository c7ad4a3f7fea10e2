#pragma once

#include <string>

namespace touchdown::util {

/// Converts bytes to Base64 text (RFC 4648) on one line, and back.
std::string Base64(const std::string& bytes);
/// Throws std::invalid_argument for text that is not Base64.
std::string FromBase64(const std::string& text);

}  // namespace touchdown::util
