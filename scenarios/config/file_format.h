#pragma once

#include "models/describe.h"
#include "scenarios/config/config_node.h"

namespace touchdown::config {

/// Returns the keys of a section from the root of a file that replaces it. The file may have the format named by
/// `file`. Throws InputError for a file of that format which is not valid, and std::logic_error for a format without a
/// reader.
ConfigNode SectionKeys(ConfigNode root, const models::SectionFile& file);

}  // namespace touchdown::config
