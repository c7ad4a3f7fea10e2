#pragma once

#include <cairo/cairo.h>

#include <string>

namespace touchdown::report {

/// The write function of a cairo stream surface whose closure is a std::string: appends to it.
inline cairo_status_t AppendBytes(void* bytes, const unsigned char* data, unsigned length) {
  static_cast<std::string*>(bytes)->append(reinterpret_cast<const char*>(data), length);
  return CAIRO_STATUS_SUCCESS;
}

}  // namespace touchdown::report
