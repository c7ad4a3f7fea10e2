#pragma once

#include <string>
#include <vector>

namespace touchdown::util {

/// SHA-256 of the texts, one after the other, in lower-case hexadecimal.
std::string Sha256(const std::vector<const std::string*>& texts);

}  // namespace touchdown::util
