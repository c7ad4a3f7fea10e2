#pragma once

#include <string>

#include "scenarios/study/classifier_network.h"

namespace touchdown::scenarios {

/// The network as the C file that estimator/paper/classifier_weights.h declares: constant single-precision tables, in
/// which every number reads back as itself, and one function. It needs no heap and, of the C library, only expf. In the
/// spirit of SNNS' snns2c, which the paper used (Sec. IV-A.3). Throws std::invalid_argument unless the network is of
/// 196 inputs and 3 outputs.
std::string ClassifierCode(const Perceptron& network);

}  // namespace touchdown::scenarios
