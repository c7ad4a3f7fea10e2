#pragma once

#include <memory>
#include <string>
#include <string_view>

namespace touchdown::util {

/// SHA-256 of a text that is added in pieces.
class Sha256Stream {
 public:
  Sha256Stream();
  ~Sha256Stream();

  void Add(std::string_view piece);
  /// Ends the stream. Returns the digest in lower-case hexadecimal.
  std::string Finish();

 private:
  struct Context;
  std::unique_ptr<Context> context_;
};

/// SHA-256 of a text, in lower-case hexadecimal.
std::string Sha256(std::string_view text);

}  // namespace touchdown::util
