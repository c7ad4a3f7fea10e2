#pragma once

#include <cairo/cairo.h>

#include <string>

namespace touchdown::report {

/// Write function of a cairo stream surface. The closure `bytes` points to a std::string, to which it appends `data`.
inline cairo_status_t AppendBytes(void* bytes, const unsigned char* data, unsigned length) {
  static_cast<std::string*>(bytes)->append(reinterpret_cast<const char*>(data), length);
  return CAIRO_STATUS_SUCCESS;
}

}  // namespace touchdown::report
