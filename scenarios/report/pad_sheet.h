#pragma once

#include <string>

#include "models/landing_pad.h"

namespace touchdown::report {

/// Signature that identifies a pad sheet.
inline constexpr char kPadSheetSignature[] = "Touchdown landing pad";

enum class SheetFormat { kPdf, kSvg };

/// Draws the landing pad to scale for printing and returns the bytes of a PDF or SVG file. The X axis of the pad frame
/// points up on the page. The dimensions of the pad and a 100 mm ruler are below the pad. When they do not fit on the
/// sheet of the pad, the page is larger than the sheet and a dashed line shows where to cut. Throws InputError when the
/// pad is invalid.
std::string PadSheet(const models::LandingPad& pad, SheetFormat format);

}  // namespace touchdown::report
