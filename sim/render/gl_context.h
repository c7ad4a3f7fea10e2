#pragma once

#include <memory>

namespace touchdown::sim {

/// An OpenGL context without a window.
class GlContext {
 public:
  virtual ~GlContext() = default;

  /// Makes it the calling thread's current context. Call before any OpenGL or mjr_ function that uses it: the process
  /// may have made another context current.
  virtual void MakeCurrent() = 0;
};

/// Mesa's software renderer (OSMesa, llvmpipe). It renders in the calling thread unless the environment variable
/// LP_NUM_THREADS is set; pixels are the same for any number of threads. Throws std::runtime_error when Mesa cannot
/// make a context.
std::unique_ptr<GlContext> MakeOsMesaContext();

}  // namespace touchdown::sim
