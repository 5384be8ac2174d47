#pragma once

#include "hexoderm/solve/checks/evaluation.h"
#include "widgets/style/of_enum.h"

#include <QCoreApplication>
#include <QString>

namespace hexoderm {

struct SurfaceWords {
  Q_DECLARE_TR_FUNCTIONS(hexoderm::SurfaceWords)
};

/// "Plane", "Cylinder": the name of a kind of fitted surface, in the user's language.
inline QString surfaceKindWord(SurfaceKind kind) {
  return ofEnum(kind, {SurfaceWords::tr("Plane"), SurfaceWords::tr("Sphere"), SurfaceWords::tr("Cylinder"),
                       SurfaceWords::tr("Cone")});
}

}  // namespace hexoderm
