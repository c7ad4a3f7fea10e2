#include "sim/gl_context.h"

#include <GL/osmesa.h>

#include <array>
#include <cstdlib>
#include <stdexcept>

namespace touchdown::sim {
namespace {

class OsMesaContext final : public GlContext {
 public:
  OsMesaContext() {
    setenv("LP_NUM_THREADS", "0", /*overwrite=*/0);
    constexpr int kDepthBits = 24, kStencilBits = 8, kAccumulationBits = 0;
    context_ = OSMesaCreateContextExt(OSMESA_RGBA, kDepthBits, kStencilBits, kAccumulationBits, nullptr);
    if (context_ == nullptr) throw std::runtime_error("OSMesa cannot create an OpenGL context");
    MakeCurrent();
  }

  ~OsMesaContext() override { OSMesaDestroyContext(context_); }
  OsMesaContext(const OsMesaContext&) = delete;
  OsMesaContext& operator=(const OsMesaContext&) = delete;

  void MakeCurrent() override {
    if (OSMesaGetCurrentContext() == context_) return;
    if (!OSMesaMakeCurrent(context_, window_.data(), GL_UNSIGNED_BYTE, kWindowSide, kWindowSide)) {
      throw std::runtime_error("OSMesa cannot make its OpenGL context current");
    }
  }

 private:
  /// Views are rendered into a frame buffer object: OSMesa's own window is a formality.
  static constexpr int kWindowSide = 16;

  OSMesaContext context_ = nullptr;
  std::array<unsigned char, 4 * kWindowSide * kWindowSide> window_{};
};

}  // namespace

std::unique_ptr<GlContext> MakeOsMesaContext() { return std::make_unique<OsMesaContext>(); }

}  // namespace touchdown::sim
