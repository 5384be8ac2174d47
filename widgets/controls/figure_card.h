#pragma once

#include "hexoderm/util/ids.h"

#include <QFrame>
#include <QLabel>
#include <QPoint>
#include <QRect>
#include <QString>
#include <vector>

class QToolButton;

namespace hexoderm {

class FlowLayout;

/// Where a card of this size lies beside the mouse: within `area` and never under the mouse. A null rectangle if there
/// is no such place.
QRect placeBeside(const QPoint& mouse, const QSize& card, const QRect& area);

/// A card with figures of one cell or link over a view, in the colours of the theme. One that passes is about what is
/// under the mouse and lets the mouse through. One that is kept is about what is picked: it has a button for each
/// neighbour, and one that closes it.
class FigureCard : public QFrame {
  Q_OBJECT

 public:
  enum class Kind { Passing, Kept };

  /// A neighbour that the card leads to.
  struct Neighbor {
    CellId cell;
    QString tip;  ///< rich text: the figures of the link to it
  };

  explicit FigureCard(Kind kind, QWidget* parent);

  /// `text`: rich text. `value`: what the colours say of it, a line of its own; may be empty.
  void setContent(const QString& text, const QString& value, const std::vector<Neighbor>& neighbors = {});
  [[nodiscard]] QString text() const;
  /// Its size for views that are so wide and high.
  [[nodiscard]] QSize sizeFor(const QSize& view) const;

 signals:
  void neighborChosen(hexoderm::CellId cell);
  void closed();

 protected:
  void changeEvent(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  void setNeighbors(const std::vector<Neighbor>& neighbors);
  void write();

  Kind kind_;
  QString said_;
  QString said_value_;
  QLabel* text_ = new QLabel;
  QLabel* value_ = new QLabel;
  QLabel* neighbors_word_ = nullptr;
  QWidget* neighbors_ = nullptr;
  FlowLayout* neighbor_layout_ = nullptr;
  QToolButton* close_ = nullptr;
  std::vector<QToolButton*> buttons_;
  std::vector<CellId> cells_;
};

}  // namespace hexoderm
