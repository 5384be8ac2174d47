#include "widgets/coloring/coloring_words.h"

#include <QCoreApplication>

namespace hexoderm {
namespace {

struct ColoringWords {
  Q_DECLARE_TR_FUNCTIONS(hexoderm::Coloring)
};

QString titleWithUnit(const char* title, Coloring coloring) {
  if (title == nullptr) return coloringName(coloring);
  const QString unit = QString::fromUtf8(coloringRow(coloring).unit);
  const QString words = ColoringWords::tr(title);
  return unit.isEmpty() ? words : words + QStringLiteral(", ") + unit;
}

}  // namespace

QString coloringName(Coloring coloring) { return ColoringWords::tr(coloringRow(coloring).name); }

QString graphTitle(Coloring coloring) { return titleWithUnit(coloringRow(coloring).graph_title, coloring); }

QString patchTitle(Coloring coloring) { return titleWithUnit(coloringRow(coloring).patch_title, coloring); }

QString whyNoColoring(Coloring coloring, bool has_values) {
  const char* missing = coloringRow(coloring).missing;
  return has_values || missing == nullptr ? QString() : ColoringWords::tr(missing);
}

QString patchWord(std::size_t index) { return ColoringWords::tr("patch %1").arg(index + 1); }

QString notKnownWord() { return ColoringWords::tr("not known"); }

}  // namespace hexoderm
