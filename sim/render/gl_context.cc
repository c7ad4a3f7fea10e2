#include "sim/render/gl_context.h"

#include <GL/osmesa.h>

#include <array>
#include <cstdlib>
#include <stdexcept>
#include <type_traits>

namespace touchdown::sim {
namespace {

OSMesaContext CreateContext() {
  setenv("LP_NUM_THREADS", "0", /*overwrite=*/0);
  constexpr int kDepthBits = 24, kStencilBits = 8, kAccumulationBits = 0;
  OSMesaContext context = OSMesaCreateContextExt(OSMESA_RGBA, kDepthBits, kStencilBits, kAccumulationBits, nullptr);
  if (context == nullptr) throw std::runtime_error("OSMesa cannot create an OpenGL context");
  return context;
}

class OsMesaContext final : public GlContext {
 public:
  OsMesaContext() : context_(CreateContext()) { MakeCurrent(); }

  void MakeCurrent() override {
    if (OSMesaGetCurrentContext() == context_.get()) return;
    if (!OSMesaMakeCurrent(context_.get(), window_.data(), GL_UNSIGNED_BYTE, kWindowSide, kWindowSide)) {
      throw std::runtime_error("OSMesa cannot make its OpenGL context current");
    }
  }

 private:
  /// Side of OSMesa's window, px. The window is required but not used: views are rendered into a frame buffer object.
  static constexpr int kWindowSide = 16;

  struct Destroy {
    void operator()(OSMesaContext context) const { OSMesaDestroyContext(context); }
  };

  std::array<unsigned char, 4 * kWindowSide * kWindowSide> window_{};
  std::unique_ptr<std::remove_pointer_t<OSMesaContext>, Destroy> context_;
};

}  // namespace

std::unique_ptr<GlContext> MakeOsMesaContext() { return std::make_unique<OsMesaContext>(); }

}  // namespace touchdown::sim
