#pragma once

#include <string>
#include <vector>

#include "scenarios/flight/scenario.h"
#include "scenarios/paper/experiment.h"

namespace touchdown::scenarios {

/// Figs. 2, 4 and 5 redrawn: the stages of the recognition, cluttered views from many perspectives, and the ellipses
/// fitted to patches, some of them blurred. As JSON, which PicturesFromJson reads back.
Json TakeRecognitionPictures(const Scenario& told);

std::vector<ReportPicture> PicturesFromJson(const Json& pictures);

}  // namespace touchdown::scenarios
