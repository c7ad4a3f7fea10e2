#pragma once

#include <string>

namespace touchdown::util {

/// Encodes bytes as Base64 text (RFC 4648) without line breaks.
std::string Base64(const std::string& bytes);
/// Decodes Base64 text. Throws std::invalid_argument if the text is not valid Base64.
std::string FromBase64(const std::string& text);

}  // namespace touchdown::util
