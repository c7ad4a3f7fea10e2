#include "scenarios/util/version.h"

namespace touchdown::util {

std::string_view Version() { return TOUCHDOWN_VERSION; }

}  // namespace touchdown::util
