#pragma once

#include "hexoderm/reconstruction/advice/skin_check.h"

#include <QVBoxLayout>
#include <QWidget>
#include <vector>

class QLabel;

namespace hexoderm {

/// Results of checks of a skin, one line each with a sign and its words. A fault has a button that shows where it is.
class CheckList : public QWidget {
  Q_OBJECT

 public:
  explicit CheckList(QWidget* parent = nullptr);

  void setCheck(const SkinCheck& check);

 signals:
  /// The operator wants to see where.
  void cellPicked(hexoderm::CellId cell);

 private:
  class Row;

  QVBoxLayout* layout_ = new QVBoxLayout(this);
  std::vector<Row*> rows_;
};

}  // namespace hexoderm
