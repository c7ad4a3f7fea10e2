#pragma once

#include "estimator/pad/edges.h"
#include "estimator/paper/components.h"
#include "estimator/paper/pad_detector.h"
#include "models/landing_pad.h"
#include "models/signals.h"

namespace touchdown::estimator::paper {

/// Finds the edge points of a detected pad (Sec. IV-B). An edge pixel belongs to the component on its dark side. On the
/// ring it belongs to the outer boundary if its bright side is outside.
pad::PadContours FindContours(const models::ImageView& image, const ComponentSet& components,
                              const DetectedPad& detected, const models::LandingPad& pad,
                              const pad::EdgeConfig& config = {});

}  // namespace touchdown::estimator::paper
