#pragma once

#include <stdexcept>

namespace touchdown {

/// Invalid user input: a file, a key, a value or a folder. The message is one line for the user and states file, line
/// and key where they exist. The program exits with status 2.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace touchdown
