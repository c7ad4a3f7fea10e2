#pragma once

#include <gmock/gmock.h>

#include <utility>

#include "models/error.h"

namespace touchdown::tests {

/// Matches a callable without parameters that throws InputError. `message` is a matcher for its message, or the whole
/// message. Example: EXPECT_THAT([&] { Read(file); }, ThrowsInputError(HasSubstr("no such file"))).
template <typename Message>
auto ThrowsInputError(Message message) {
  return testing::ThrowsMessage<InputError>(std::move(message));
}

}  // namespace touchdown::tests
