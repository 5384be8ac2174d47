#include "widgets/patch/opengl_info.h"

#include <QVTKOpenGLNativeWidget.h>
#include <QCoreApplication>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QStringList>
#include <algorithm>

namespace hexoderm {
namespace {

struct OpenGlWords {
  Q_DECLARE_TR_FUNCTIONS(hexoderm::OpenGlWords)
};

}  // namespace

QSurfaceFormat sceneSurfaceFormat() {
  QSurfaceFormat format = QVTKOpenGLNativeWidget::defaultFormat();
  format.setSamples(0);
  return format;
}

OpenGlInfo queryOpenGl() {
  OpenGlInfo info;
  QOpenGLContext context;
  context.setFormat(sceneSurfaceFormat());
  info.usable = context.create() && 10 * context.format().majorVersion() + context.format().minorVersion() >= 32;
  if (!info.usable) return info;
  QOffscreenSurface surface;
  surface.setFormat(context.format());
  surface.create();
  if (!context.makeCurrent(&surface)) return info;
  const GLubyte* name = context.functions()->glGetString(GL_RENDERER);
  if (name != nullptr) info.renderer = QString::fromLatin1(reinterpret_cast<const char*>(name));
  context.doneCurrent();
  const QStringList kSoftware = {QStringLiteral("llvmpipe"), QStringLiteral("softpipe"),    QStringLiteral("swrast"),
                                 QStringLiteral("software"), QStringLiteral("swiftshader"), QStringLiteral("lavapipe")};
  info.software = std::any_of(kSoftware.begin(), kSoftware.end(),
                              [&](const QString& word) { return info.renderer.contains(word, Qt::CaseInsensitive); });
  return info;
}

QString openGlText(const OpenGlInfo& info) {
  if (!info.usable) return OpenGlWords::tr("no OpenGL 3.2");
  const QString name = info.renderer.isEmpty() ? OpenGlWords::tr("unknown renderer") : info.renderer;
  return info.software ? OpenGlWords::tr("%1, in software").arg(name) : name;
}

}  // namespace hexoderm
