#pragma once

#include "hexoderm/base/ids.h"
#include "widgets/controls/flow_layout.h"
#include "widgets/controls/panel_parts.h"
#include "widgets/style/palette.h"

#include <QEvent>
#include <QFrame>
#include <QHBoxLayout>
#include <QLabel>
#include <QPoint>
#include <QRect>
#include <QString>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <vector>

namespace hexoderm {

inline constexpr int kFromMouse_px = 16;
inline constexpr int kFromEdge_px = 6;
inline constexpr int kPassingCharacters = 44;  // in its width
inline constexpr int kKeptCharacters = 36;

/// Where a card of this size lies beside the mouse: within `area` and never under the mouse. A null rectangle if there
/// is no such place.
inline QRect placeBeside(const QPoint& mouse, const QSize& card, const QRect& area) {
  const QRect room = area.adjusted(kFromEdge_px, kFromEdge_px, -kFromEdge_px, -kFromEdge_px);
  const int right = mouse.x() + kFromMouse_px;
  const int left = mouse.x() - kFromMouse_px - card.width();
  const int below = mouse.y() + kFromMouse_px;
  const int above = mouse.y() - kFromMouse_px - card.height();
  // Aside of the mouse it may be moved up and down, and above or below it to the left and right.
  const auto moved = [](int at, int length, int from, int to) { return std::max(from, std::min(at, to + 1 - length)); };
  const int y = moved(below, card.height(), room.top(), room.bottom());
  const int x = moved(right, card.width(), room.left(), room.right());
  for (const QPoint& at : {QPoint(right, y), QPoint(left, y), QPoint(x, below), QPoint(x, above)}) {
    const QRect place(at, card);
    if (room.contains(place) && !place.contains(mouse)) return place;
  }
  return {};
}

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

  explicit FigureCard(Kind kind, QWidget* parent) : QFrame(parent), kind_(kind) {
    setObjectName(kind == Kind::Passing ? QStringLiteral("hoverCard") : QStringLiteral("figureCard"));
    setProperty("notice", true);
    for (QLabel* label : {value_, text_}) {
      label->setWordWrap(true);
      label->setTextFormat(Qt::RichText);
    }
    auto* layout = spaced(new QVBoxLayout(this), {12, 9, 12, 10}, 5);
    if (kind == Kind::Passing) {
      setAttribute(Qt::WA_TransparentForMouseEvents);
      addWidgets(layout, {text_, value_});
    } else {
      auto* close = styledAs(quiet(new QToolButton(this), "closeFigures"), "flat");
      close->setText(QStringLiteral("×"));
      close->setToolTip(tr("Close this card (Esc)"));
      close->setAccessibleName(tr("Close the card with the figures"));
      connect(close, &QToolButton::clicked, this, &FigureCard::closed);
      auto* head = new QHBoxLayout;
      head->addWidget(text_, 1, Qt::AlignTop);
      head->addWidget(close, 0, Qt::AlignTop);
      layout->addLayout(head);
      layout->addWidget(value_);
      neighbors_word_ = styledAs(new QLabel(tr("Neighbours"), this), "muted");
      layout->addWidget(neighbors_word_);
      neighbors_ = new QWidget(this);
      spaced(new FlowLayout(neighbors_), {0, 0, 0, 0}, 5);
      layout->addWidget(neighbors_);
    }
    hide();
  }

  /// `text`: rich text. `value`: what the colours say of it, a line of its own; may be empty.
  void setContent(const QString& text, const QString& value, const std::vector<Neighbor>& neighbors = {}) {
    said_ = text;
    said_value_ = value;
    write();
    value_->setVisible(!value.isEmpty());
    if (neighbors_ != nullptr) setNeighbors(neighbors);
  }

  [[nodiscard]] QString text() const {
    return said_value_.isEmpty() ? said_ : said_ + QStringLiteral("<br>") + said_value_;
  }

  /// Its size for views that are so wide and high.
  [[nodiscard]] QSize sizeFor(const QSize& view) const {
    const int characters = kind_ == Kind::Passing ? kPassingCharacters : kKeptCharacters;
    const int wanted = characters * fontMetrics().averageCharWidth();
    const int width = std::min(wanted, std::max(0, view.width() - 2 * kFromEdge_px));
    ensurePolished();
    layout()->activate();
    return {width,
            layout()->hasHeightForWidth() ? layout()->totalHeightForWidth(width) : layout()->totalSizeHint().height()};
  }

 signals:
  void neighborChosen(hexoderm::CellId cell);
  void closed();

 protected:
  void changeEvent(QEvent* event) override {
    QFrame::changeEvent(event);
    if (event->type() == QEvent::PaletteChange) write();
  }

 private:
  void setNeighbors(const std::vector<Neighbor>& neighbors) {
    neighbors_word_->setVisible(!neighbors.empty());
    neighbors_->setVisible(!neighbors.empty());
    // Buttons stay, so that one that has the keyboard keeps it.
    while (buttons_.size() < neighbors.size()) {
      auto* button = new QToolButton(neighbors_);
      button->setFocusPolicy(Qt::TabFocus);
      const std::size_t k = buttons_.size();
      connect(button, &QToolButton::clicked, this, [this, k] { emit neighborChosen(cells_[k]); });
      neighbors_->layout()->addWidget(button);
      buttons_.push_back(button);
    }
    cells_.clear();
    for (std::size_t k = 0; k < buttons_.size(); ++k) {
      buttons_[k]->setVisible(k < neighbors.size());
      if (k >= neighbors.size()) continue;
      cells_.push_back(neighbors[k].cell);
      buttons_[k]->setObjectName(QStringLiteral("neighbor%1").arg(neighbors[k].cell.value()));
      buttons_[k]->setText(QString::number(neighbors[k].cell.value()));
      buttons_[k]->setAccessibleName(tr("Go to cell %1").arg(neighbors[k].cell.value()));
      buttons_[k]->setToolTip(neighbors[k].tip);
    }
  }

  /// The colour stands in the text: rich text does not follow a palette that a style sheet sets anew.
  void write() {
    const QString begin = QStringLiteral("<span style=\"color:%1\">").arg(Colors::of(palette()).text.name());
    const QString end = QStringLiteral("</span>");
    text_->setText(begin + said_ + end);
    value_->setText(said_value_.isEmpty() ? QString() : begin + said_value_ + end);
  }

  Kind kind_;
  QString said_;
  QString said_value_;
  QLabel* text_ = named(new QLabel, "figureText");
  QLabel* value_ = named(new QLabel, "figureValue");
  QLabel* neighbors_word_ = nullptr;
  QWidget* neighbors_ = nullptr;
  std::vector<QToolButton*> buttons_;
  std::vector<CellId> cells_;
};

}  // namespace hexoderm
