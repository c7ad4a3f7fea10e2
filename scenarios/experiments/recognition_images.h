#pragma once

#include <string>
#include <vector>

#include "scenarios/experiments/experiment.h"
#include "scenarios/runner/scenario.h"

namespace touchdown::experiments {

/// Images that correspond to Figs. 2, 4 and 5: the stages of the recognition, cluttered views from several
/// perspectives, and the ellipses fitted in image patches, some of them blurred. Returns JSON that ImagesFromJson()
/// reads.
Json MakeRecognitionImages(const runner::Scenario& nominal);

/// Images of the report from the result of MakeRecognitionImages().
std::vector<report::ReportImage> ImagesFromJson(const Json& images);

}  // namespace touchdown::experiments
