#pragma once

#include <string>
#include <vector>

#include "scenarios/experiments/experiment.h"
#include "scenarios/runner/scenario.h"

namespace touchdown::experiments {

/// Figs. 2, 4 and 5 redrawn: the stages of the recognition, cluttered views from many perspectives, and the ellipses
/// fitted to patches, some of them blurred. As JSON, which PicturesFromJson reads back.
Json TakeRecognitionPictures(const runner::Scenario& nominal);

std::vector<report::ReportPicture> PicturesFromJson(const Json& pictures);

}  // namespace touchdown::experiments
