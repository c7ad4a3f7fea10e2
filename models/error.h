#pragma once

#include <stdexcept>

namespace touchdown {

/// Something the user gave is unusable: a file, a key, a value, a folder. The message is one line, written for
/// that user, and names file, line and key where there are any. The program ends with status 2.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace touchdown
