#pragma once

#include <string>
#include <utility>
#include <vector>

#include "models/landing_pad.h"
#include "scenarios/training/classifier_network.h"

namespace touchdown::training {

/// Generates the C file of a network, like the tool snns2c of SNNS, which the paper used (Sec. IV-A.3).
///
/// The file defines the function that estimator/paper/classifier_weights.h declares for this letter. It contains
/// constant tables in single precision, whose literals read back bit-identical, and one function, which needs no heap
/// and only expf from the C library. `provenance` (names and values) is written to the comment at the top: with equal
/// provenance, the training gives the same file. Throws std::invalid_argument unless the network has 196 inputs and 3
/// outputs.
std::string ClassifierCode(const Perceptron& network, models::PadLetter letter,
                           const std::vector<std::pair<std::string, std::string>>& provenance);

}  // namespace touchdown::training
