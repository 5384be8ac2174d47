#include "widgets/words/surface_words.h"

#include "widgets/style/of_enum.h"

#include <QCoreApplication>

namespace hexoderm {
namespace {

struct SurfaceWords {
  Q_DECLARE_TR_FUNCTIONS(hexoderm::SurfaceWords)
};

}  // namespace

QString surfaceKindWord(SurfaceKind kind) {
  return ofEnum(kind, {SurfaceWords::tr("Plane"), SurfaceWords::tr("Sphere"), SurfaceWords::tr("Cylinder"),
                       SurfaceWords::tr("Cone")});
}

}  // namespace hexoderm
