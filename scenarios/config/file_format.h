#pragma once

#include "models/describe.h"
#include "scenarios/config/config_node.h"

namespace touchdown::config {

/// Keys of a section from the root of a file that defines it. The file has these keys or the format that `file` names.
/// Throws InputError for an invalid file of that format and std::logic_error for an unknown format.
ConfigNode SectionKeys(ConfigNode root, const models::SectionFile& file);

}  // namespace touchdown::config
