#pragma once

#include "hexoderm/util/ids.h"

#include <QFrame>
#include <functional>

class QLabel;
class QLineEdit;

namespace hexoderm {

/// The small field in which the ID of a cell is typed: it appears when it is needed and goes when it is done.
class FindCellField : public QFrame {
  Q_OBJECT

 public:
  /// `exists` says whether there is such a cell.
  FindCellField(std::function<bool(CellId)> exists, QWidget* parent);

  /// Shows the field with `text` as its beginning.
  void open(const QString& text);

 signals:
  /// While typing, each time the digits name a cell.
  void found(quint32 cell);
  void closed();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void look();
  void finish();

  std::function<bool(CellId)> exists_;
  QLineEdit* field_;
  QLabel* answer_;
};

}  // namespace hexoderm
