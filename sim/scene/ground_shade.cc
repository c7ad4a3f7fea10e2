#include "sim/scene/ground_shade.h"

#include <GL/gl.h>

namespace touchdown::sim {
namespace {

/// Height of the shade, m, above all sheets on the ground.
constexpr double kHeight_m = 0.0010;

/// Sets OpenGL to multiply the image by the texture where the depth test passes.
void MultiplyByTexture() {
  for (const GLenum off :
       {GL_LIGHTING, GL_CULL_FACE, GL_ALPHA_TEST, GL_TEXTURE_GEN_S, GL_TEXTURE_GEN_T, GL_TEXTURE_CUBE_MAP}) {
    glDisable(off);
  }
  glEnable(GL_DEPTH_TEST);
  glDepthMask(GL_FALSE);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ZERO, GL_SRC_COLOR);
  glEnable(GL_TEXTURE_2D);
  glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
}

}  // namespace

void GroundShadePainter::Upload(const cv::Mat1b& light) {
  if (texture_ == 0) {
    glGenTextures(1, &texture_);
    glBindTexture(GL_TEXTURE_2D, texture_);
    for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER}) {
      glTexParameteri(GL_TEXTURE_2D, filter, GL_LINEAR);
    }
    for (const GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T}) {
      glTexParameteri(GL_TEXTURE_2D, wrap, GL_CLAMP_TO_EDGE);
    }
  }
  glBindTexture(GL_TEXTURE_2D, texture_);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_LUMINANCE8, light.cols, light.rows, 0, GL_LUMINANCE, GL_UNSIGNED_BYTE, light.data);
}

void GroundShadePainter::Paint(const GroundShade& shade) {
  glPushAttrib(GL_ENABLE_BIT | GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_TEXTURE_BIT | GL_CURRENT_BIT);
  Upload(shade.light);
  MultiplyByTexture();
  glBegin(GL_QUADS);
  for (const auto& [s, t] : {std::pair(0, 1), std::pair(1, 1), std::pair(1, 0), std::pair(0, 0)}) {
    glTexCoord2i(s, t);
    glVertex3d(shade.center_m.x() + (s - 0.5) * shade.side_m, shade.center_m.y() + (0.5 - t) * shade.side_m, kHeight_m);
  }
  glEnd();
  glPopAttrib();
}

}  // namespace touchdown::sim
