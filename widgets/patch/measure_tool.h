#pragma once

#include "hexoderm/reconstruction/result/reconstruction.h"

#include <QObject>
#include <QString>
#include <memory>
#include <optional>

class QShortcut;
class QWidget;

namespace hexoderm {

class Selection;

/// Measures from cell to cell: while it is on, the cells that are picked, here or in any other view, are its two ends
/// in turns. Esc ends it.
class MeasureTool : public QObject {
  Q_OBJECT

 public:
  /// Both must outlive the tool; Esc is heard in the widget's window.
  MeasureTool(Selection* selection, QWidget* widget);

  void setReconstruction(std::shared_ptr<const Reconstruction> reconstruction);
  /// A cell that is picked already is the first end.
  void setActive(bool active);
  [[nodiscard]] bool isActive() const { return active_; }
  [[nodiscard]] std::optional<CellId> first() const { return first_; }
  [[nodiscard]] std::optional<CellId> second() const { return second_; }
  /// The distance, or what is waited for; empty while it is off.
  [[nodiscard]] QString words() const;

 signals:
  void changed();

 private:
  void takePicked();

  Selection* selection_;
  QShortcut* escape_;
  std::shared_ptr<const Reconstruction> reconstruction_;
  bool active_ = false;
  std::optional<CellId> first_;
  std::optional<CellId> second_;
};

}  // namespace hexoderm
