#pragma once

#include <memory>

namespace touchdown::sim {

/// An OpenGL context without a window.
class GlContext {
 public:
  virtual ~GlContext() = default;

  /// Makes it the calling thread's current context. Call before any OpenGL or mjr_ function on what belongs to it:
  /// another context of the same process may have been made current since.
  virtual void MakeCurrent() = 0;
};

/// Mesa's software renderer (OSMesa, llvmpipe). It renders in the calling thread unless LP_NUM_THREADS says otherwise
/// in the environment: pixels are the same for any number of threads. Throws std::runtime_error when Mesa cannot make a
/// context.
std::unique_ptr<GlContext> MakeOsMesaContext();

}  // namespace touchdown::sim
