#pragma once

#include "hexoderm/solve/metrics/overlays.h"
#include "hexoderm/solve/result/reconstruction.h"
#include "widgets/controls/selection.h"
#include "widgets/patch/patch_words.h"

#include <QObject>
#include <QShortcut>
#include <QString>
#include <QWidget>
#include <memory>
#include <optional>
#include <utility>

namespace hexoderm {

/// Measures from cell to cell: while it is on, the cells that are picked, here or in any other view, are its two ends
/// in turns. Esc ends it.
class MeasureTool : public QObject {
  Q_OBJECT

 public:
  /// Both must outlive the tool; Esc is heard in the widget's window.
  MeasureTool(Selection* selection, QWidget* widget)
      : selection_(selection), escape_(new QShortcut(QKeySequence(Qt::Key_Escape), widget)) {
    escape_->setEnabled(false);
    connect(escape_, &QShortcut::activated, this, [this] { setActive(false); });
    connect(escape_, &QShortcut::activatedAmbiguously, this, [this] { setActive(false); });
    connect(selection_, &Selection::changed, this, &MeasureTool::takePicked);
  }

  void setReconstruction(std::shared_ptr<const Reconstruction> reconstruction) {
    reconstruction_ = std::move(reconstruction);
    const auto gone = [this](std::optional<CellId> cell) {
      return cell && (!reconstruction_ || reconstruction_->find(*cell).cell == nullptr);
    };
    if (!gone(first_) && !gone(second_)) return;
    first_.reset();
    second_.reset();
    emit changed();
  }

  /// A cell that is picked already is the first end.
  void setActive(bool active) {
    if (active == active_) return;
    active_ = active;
    escape_->setEnabled(active);
    first_ = active ? selection_->cell() : std::nullopt;
    second_.reset();
    emit changed();
  }

  [[nodiscard]] bool isActive() const { return active_; }
  [[nodiscard]] std::optional<CellId> first() const { return first_; }
  [[nodiscard]] std::optional<CellId> second() const { return second_; }
  /// The distance, or what is waited for; empty while it is off.
  [[nodiscard]] QString words() const {
    if (!active_) return {};
    if (!first_) return tr("Measure: pick the first cell (Esc ends)");
    if (!second_) return tr("Measure from cell %1: pick the second cell (Esc ends)").arg(first_->value());
    return distanceText(*first_, *second_,
                        reconstruction_ ? distanceBetween(*reconstruction_, *first_, *second_) : std::nullopt);
  }

 signals:
  void changed();

 private:
  void takePicked() {
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

  Selection* selection_;
  QShortcut* escape_;
  std::shared_ptr<const Reconstruction> reconstruction_;
  bool active_ = false;
  std::optional<CellId> first_;
  std::optional<CellId> second_;
};

}  // namespace hexoderm
