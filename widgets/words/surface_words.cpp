#include "widgets/words/surface_words.h"

#include <QCoreApplication>

namespace hexoderm {
namespace {

struct SurfaceWords {
  Q_DECLARE_TR_FUNCTIONS(hexoderm::SurfaceWords)
};

}  // namespace

QString surfaceKindWord(SurfaceKind kind) {
  switch (kind) {
    case SurfaceKind::Plane:
      return SurfaceWords::tr("Plane");
    case SurfaceKind::Sphere:
      return SurfaceWords::tr("Sphere");
    case SurfaceKind::Cylinder:
      return SurfaceWords::tr("Cylinder");
    case SurfaceKind::Cone:
      return SurfaceWords::tr("Cone");
  }
  return {};
}

}  // namespace hexoderm
