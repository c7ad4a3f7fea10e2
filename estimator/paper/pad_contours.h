#pragma once

#include "estimator/pad/edges.h"
#include "estimator/paper/components.h"
#include "estimator/paper/pad_detector.h"
#include "models/landing_pad.h"
#include "models/signals.h"

namespace touchdown::estimator::paper {

/// Edge points of a detected pad (Sec. IV-B): an edge pixel belongs to the component on its dark side; on the ring it
/// is on the outer boundary where the bright side is outwards.
pad::PadContours FindContours(const models::ImageView& image, const ComponentSet& components,
                              const DetectedPad& detected, const models::LandingPad& pad,
                              const pad::EdgeConfig& config = {});

}  // namespace touchdown::estimator::paper
