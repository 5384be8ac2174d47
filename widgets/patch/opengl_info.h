#pragma once

#include <QString>
#include <QSurfaceFormat>

namespace hexoderm {

/// The OpenGL implementation that draws here.
struct OpenGlInfo {
  bool usable = false;    ///< OpenGL 3.2 or newer, which VTK needs
  bool software = false;  ///< drawn by the processor, not by a graphics card
  QString renderer;       ///< the driver's own name; empty if not usable
};

/// Without multisampling, which costs a factor of three in software OpenGL.
QSurfaceFormat sceneSurfaceFormat();

/// Makes a context for a moment to ask it.
OpenGlInfo queryOpenGl();

/// "llvmpipe (LLVM 15.0.6, 256 bits), in software": one line for a menu, an about box, a log.
QString openGlText(const OpenGlInfo& info);

}  // namespace hexoderm
