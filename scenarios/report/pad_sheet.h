#pragma once

#include <string>

#include "models/landing_pad.h"

namespace touchdown::report {

/// Every sheet holds this text.
inline constexpr char kPadSheetSignature[] = "Touchdown landing pad";

enum class SheetFormat { kPdf, kSvg };

/// The landing pad to print, as the bytes of a PDF or SVG file, to scale: X of the pad's frame points up the page.
/// Below the pad are its dimensions and a ruler of 100 mm; where the pad's own sheet has no room for them, the page is
/// larger than the sheet and a dashed line shows where to cut. Throws InputError when the pad is not valid.
std::string PadSheet(const models::LandingPad& pad, SheetFormat format);

}  // namespace touchdown::report
