#pragma once

#include <string>
#include <utility>
#include <vector>

#include "models/landing_pad.h"
#include "scenarios/training/classifier_network.h"

namespace touchdown::training {

/// The network as the C file of the function that estimator/paper/classifier_weights.h declares for this letter:
/// constant single-precision tables, in which every number reads back as itself, and one function. It needs no heap
/// and, of the C library, only expf. In the spirit of SNNS' snns2c, which the paper used (Sec. IV-A.3). `provenance`,
/// names and values, stands in the comment at its head: where they are the same, the training gives the same file.
/// Throws std::invalid_argument unless the network is of 196 inputs and 3 outputs.
std::string ClassifierCode(const Perceptron& network, models::PadLetter letter,
                           const std::vector<std::pair<std::string, std::string>>& provenance);

}  // namespace touchdown::training
