#pragma once

#include <string>

namespace touchdown::util {

/// Bytes as Base64 text (RFC 4648), on one line, and back.
std::string Base64(const std::string& bytes);
/// Throws std::invalid_argument for a text that is no Base64.
std::string FromBase64(const std::string& text);

}  // namespace touchdown::util
