#pragma once

#include "models/describe.h"
#include "scenarios/config/config_node.h"

namespace touchdown::config {

/// The keys of a section from the root of a file that stands in its place, also where the file has the format that
/// `file` names. Throws InputError for a file of that format which is not valid, and std::logic_error for a format
/// without a reader.
ConfigNode SectionKeys(ConfigNode root, const models::SectionFile& file);

}  // namespace touchdown::config
