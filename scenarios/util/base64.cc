#include "scenarios/util/base64.h"

#include <openssl/evp.h>

#include <stdexcept>

namespace touchdown::util {
namespace {

unsigned char* Bytes(std::string& text) { return reinterpret_cast<unsigned char*>(text.data()); }
const unsigned char* Bytes(const std::string& text) { return reinterpret_cast<const unsigned char*>(text.data()); }

}  // namespace

std::string Base64(const std::string& bytes) {
  std::string text(4 * ((bytes.size() + 2) / 3) + 1, '\0');  // OpenSSL appends a zero byte.
  text.resize(static_cast<std::size_t>(EVP_EncodeBlock(Bytes(text), Bytes(bytes), static_cast<int>(bytes.size()))));
  return text;
}

std::string FromBase64(const std::string& text) {
  std::string bytes(3 * (text.size() / 4), '\0');
  if (EVP_DecodeBlock(Bytes(bytes), Bytes(text), static_cast<int>(text.size())) < 0) {
    throw std::invalid_argument("the text is not valid Base64");
  }
  const std::size_t padding = text.size() - 1 - text.find_last_not_of('=');
  bytes.resize(bytes.size() - (text.empty() ? 0 : padding));
  return bytes;
}

}  // namespace touchdown::util
