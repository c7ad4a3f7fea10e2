#pragma once

#include <memory>

namespace touchdown::sim {

/// An OpenGL context without a window.
class GlContext {
 public:
  virtual ~GlContext() = default;

  /// Makes this the calling thread's current context. Call it before any OpenGL or mjr_ function that uses the context,
  /// since another one may be current.
  virtual void MakeCurrent() = 0;
};

/// Makes a context of Mesa's software renderer (OSMesa, llvmpipe). It renders in the calling thread unless the
/// environment variable LP_NUM_THREADS is set; pixels are the same for any number of threads. Throws std::runtime_error
/// when Mesa cannot make a context.
std::unique_ptr<GlContext> MakeOsMesaContext();

}  // namespace touchdown::sim
