#pragma once

#include <QImage>

namespace hexoderm {

/// The picture with its edges smoothed and nothing else changed: FXAA (T. Lottes, "FXAA", NVIDIA, 2009), on the
/// processor. In software OpenGL a shader takes several times as long for the same, and the window waits for all of it.
/// For Format_RGB32 of any size, also none; keeps the picture's density.
QImage smoothEdges(const QImage& picture);

}  // namespace hexoderm
