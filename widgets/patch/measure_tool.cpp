#include "widgets/patch/measure_tool.h"

#include "hexoderm/reconstruction/figures/overlays.h"
#include "widgets/controls/selection.h"
#include "widgets/patch/patch_words.h"

#include <QShortcut>
#include <QWidget>
#include <utility>

namespace hexoderm {

MeasureTool::MeasureTool(Selection* selection, QWidget* widget)
    : selection_(selection), escape_(new QShortcut(QKeySequence(Qt::Key_Escape), widget)) {
  escape_->setEnabled(false);
  connect(escape_, &QShortcut::activated, this, [this] { setActive(false); });
  connect(escape_, &QShortcut::activatedAmbiguously, this, [this] { setActive(false); });
  connect(selection_, &Selection::changed, this, &MeasureTool::takePicked);
}

void MeasureTool::setReconstruction(std::shared_ptr<const Reconstruction> reconstruction) {
  reconstruction_ = std::move(reconstruction);
  const auto gone = [this](std::optional<CellId> cell) {
    return cell && (!reconstruction_ || reconstruction_->find(*cell).cell == nullptr);
  };
  if (!gone(first_) && !gone(second_)) return;
  first_.reset();
  second_.reset();
  emit changed();
}

void MeasureTool::setActive(bool active) {
  if (active == active_) return;
  active_ = active;
  escape_->setEnabled(active);
  first_ = active ? selection_->cell() : std::nullopt;
  second_.reset();
  emit changed();
}

void MeasureTool::takePicked() {
  const std::optional<CellId> picked = selection_->cell();
  if (!active_ || !picked) return;
  if (first_ && !second_ && *picked != *first_) {
    second_ = picked;
  } else {
    first_ = picked;
    second_.reset();
  }
  emit changed();
}

QString MeasureTool::words() const {
  if (!active_) return {};
  if (!first_) return tr("Measure: pick the first cell (Esc ends)");
  if (!second_) return tr("Measure from cell %1: pick the second cell (Esc ends)").arg(first_->value());
  return distanceInWords(*first_, *second_,
                         reconstruction_ ? distanceBetween(*reconstruction_, *first_, *second_) : std::nullopt);
}

}  // namespace hexoderm
