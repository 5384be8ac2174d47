#pragma once

#include "hexoderm/reconstruction/evaluation/evaluation.h"

#include <QString>

namespace hexoderm {

/// "Plane", "Cylinder": the name of a kind of fitted surface, in the user's language.
QString surfaceKindWord(SurfaceKind kind);

}  // namespace hexoderm
