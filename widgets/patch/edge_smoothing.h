#pragma once

#include <QImage>

namespace hexoderm {

/// The picture with its edges smoothed, nothing else changed: what FXAA does (T. Lottes, "FXAA", NVIDIA, 2009), on the
/// processor. In software OpenGL the same as a shader takes several times as long, and all of it is waited for.
/// For Format_RGB32 of any size, also none; keeps the picture's density.
QImage smoothEdges(const QImage& picture);

}  // namespace hexoderm
