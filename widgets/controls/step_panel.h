#pragma once

#include "widgets/controls/action_button.h"
#include "widgets/controls/flow_layout.h"
#include "widgets/controls/panel_parts.h"
#include "widgets/style/of_enum.h"
#include "widgets/style/palette.h"
#include "widgets/words/formatting.h"

#include <QAbstractButton>
#include <QApplication>
#include <QEvent>
#include <QLabel>
#include <QPainter>
#include <QScrollArea>
#include <QScrollBar>
#include <QTimer>
#include <QVBoxLayout>
#include <QVariant>
#include <algorithm>
#include <vector>

class QAction;

namespace hexoderm {

enum class StepState { Waiting, Current, Done };

/// Whether a step can be taken. Possible: allowed, but not recommended yet. Waiting: allowed as soon as something
/// arrives that is on its way. Blocked: somebody has to do something first.
enum class Readiness { Ready, Possible, Waiting, Blocked };

/// One step from "connect" to "export": what it is, where it stands, what to do and why.
struct Step {
  QString title;
  QString note;  ///< one line under the title: "17 cells, 16 links, 1 patch"
  StepState state = StepState::Waiting;
  QString what;  ///< the present task
  QString why;   ///< why, or what it is waiting for
  Readiness readiness = Readiness::Blocked;
  QString because;  ///< why, as a sentence; empty: nothing is said
  std::vector<QAction*> actions;
};

/// The steps from top to bottom. One is open: the one that was clicked, or that openStep() named; a step never gives
/// way to another by itself, while somebody reads it. Its width is its place's: no text and no body widens it.
class StepPanel : public QScrollArea {
  Q_OBJECT

 public:
  explicit StepPanel(QWidget* parent = nullptr) : QScrollArea(parent), layout_(nullptr) {
    setNames(this, QStringLiteral("stepPanel"), tr("Steps"));
    // Its steps take the focus, and are scrolled into view then.
    scrollPlainly(this);
    auto* content = named(new QWidget, "stepContent");
    layout_ = spaced(new QVBoxLayout(content), {0, 4, 0, 4}, 0);
    layout_->addStretch(1);
    // It scrolls up and down only, and is as wide as its place, whatever is in it.
    content->setMinimumWidth(1);
    setWidget(content);
    setUpOnce(make_room_, 0, this, [this] {
      // An operator who has scrolled meanwhile stays there, and so does one who is at another heading by the keyboard.
      if (verticalScrollBar()->value() == placed_at_ && !isFocusElsewhere()) makeRoom();
    });
  }

  /// Property of the buttons that open a step: pressing it would change nothing.
  static constexpr const char* kIsOpen = "stepIsOpen";

  void setSteps(const std::vector<Step>& steps) {
    while (rows_.size() < steps.size()) {
      const auto index = static_cast<int>(rows_.size());
      auto* row = new Row(index + 1, widget());
      row->installEventFilter(this);
      connect(row->head(), &QAbstractButton::clicked, this, [this, index] { openStep(index); });
      layout_->insertWidget(index, row);
      rows_.push_back(row);
      if (rows_.size() <= bodies_.size() && bodies_[rows_.size() - 1]) row->setContent(bodies_[rows_.size() - 1]);
    }
    for (std::size_t k = 0; k < rows_.size(); ++k) {
      rows_[k]->setVisible(k < steps.size());
      if (k < steps.size()) rows_[k]->set(steps[k]);
    }
    showOpenRow();
  }

  /// Sets the content of a step beside its words, once there is such a step; the panel takes ownership.
  void setBody(int step, QWidget* body) {
    const auto index = static_cast<std::size_t>(step);
    if (bodies_.size() <= index) bodies_.resize(index + 1, nullptr);
    bodies_[index] = body;
    if (index < rows_.size()) rows_[index]->setContent(body);
  }

  [[nodiscard]] int openIndex() const { return static_cast<int>(open_); }

 public slots:
  /// Nothing happens if there is no such step.
  void openStep(int step) {
    if (step < 0 || static_cast<std::size_t>(step) >= rows_.size()) return;
    open_ = static_cast<std::size_t>(step);
    showOpenRow();
    makeRoom();
    make_room_.start();
    emit opened(step);
  }

  /// Opens a step, and moves the keyboard to its heading.
  void goToStep(int step) {
    openStep(step);
    if (step != openIndex()) return;
    QAbstractButton* head = rows_[open_]->head();
    head->setFocus(Qt::ShortcutFocusReason);
    ensureWidgetVisible(head);
  }

 signals:
  void opened(int step);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override {
    if (event->type() == QEvent::Resize && open_ < rows_.size() && watched == rows_[open_]) makeRoomSoon();
    return QScrollArea::eventFilter(watched, event);
  }

  bool focusNextPrevChild(bool next) override {
    const bool is_placed = verticalScrollBar()->value() == placed_at_;
    const bool has_moved = QScrollArea::focusNextPrevChild(next);
    if (is_placed) placed_at_ = verticalScrollBar()->value();
    return has_moved;
  }

  void resizeEvent(QResizeEvent* event) override {
    if (open_ < rows_.size()) makeRoomSoon();
    QScrollArea::resizeEvent(event);
  }

 private:
  class Row;

  void showOpenRow() {
    for (std::size_t k = 0; k < rows_.size(); ++k) rows_[k]->setOpen(k == open_);
  }

  /// If the open step does not fit below the steps before it, these give way; its widget with the focus stays in view.
  void makeRoom() {
    // Steps before it that were closed, and the bar's range, are only where they belong after the layout.
    widget()->layout()->activate();
    const Row* row = rows_[open_];
    QWidget* focus = QApplication::focusWidget();
    QScrollBar* bar = verticalScrollBar();
    const int height = viewport()->height();
    const int end = row->y() + row->height();
    const bool is_seen = row->y() >= bar->value() && end <= bar->value() + height;
    if (!is_seen) bar->setValue(end <= height ? 0 : row->y());
    // An operator who works in it with the keyboard does not lose the place.
    if (focus != nullptr && row->isAncestorOf(focus)) ensureWidgetVisible(focus);
    placed_at_ = bar->value();
  }

  void makeRoomSoon() {
    if (verticalScrollBar()->value() == placed_at_ && !isFocusElsewhere()) make_room_.start();
  }

  /// At the heading of another step.
  [[nodiscard]] bool isFocusElsewhere() const {
    const QWidget* focus = QApplication::focusWidget();
    return focus != nullptr && widget()->isAncestorOf(focus) && !rows_[open_]->isAncestorOf(focus);
  }

  QVBoxLayout* layout_;
  std::vector<Row*> rows_;
  std::vector<QWidget*> bodies_;  ///< by step; null where there is none
  std::size_t open_ = 0;
  QTimer make_room_;
  int placed_at_ = 0;  ///< the scroll bar's value as it was set here, as long as nobody else scrolls

  static QString readinessText(Readiness readiness) {
    return ofEnum(readiness, {StepPanel::tr("✓ Ready: %1"), StepPanel::tr("▲ Possible: %1"),
                              StepPanel::tr("… Waiting: %1"), StepPanel::tr("■ Blocked: %1")});
  }

  static constexpr int kBadge = 24;
  static constexpr int kMargin = 14;
  static constexpr int kIndent = kMargin + kBadge + 10;

  static QString stateText(StepState state) {
    return ofEnum(state, {StepPanel::tr("waiting"), StepPanel::tr("current"), StepPanel::tr("done")});
  }

  /// Number or tick, title and note; pressing it opens the step.
  class StepHead : public QAbstractButton {
   public:
    StepHead(int number, QWidget* parent) : QAbstractButton(parent), number_(number) {
      setFocusPolicy(Qt::TabFocus);
      setCursor(Qt::PointingHandCursor);
      QSizePolicy policy(QSizePolicy::Expanding, QSizePolicy::Minimum);
      policy.setHeightForWidth(true);
      setSizePolicy(policy);
    }

    void set(const Step& step) {
      title_ = step.title;
      note_ = step.note;
      state_ = step.state;
      setAccessibleName(StepPanel::tr("Step %1, %2: %3").arg(number_).arg(title_, stateText(state_)));
      setAccessibleDescription(note_);
      updateGeometry();
      update();
    }
    void setOpen(bool open) {
      open_ = open;
      setProperty(StepPanel::kIsOpen, open);
      update();
    }

    QSize sizeHint() const override { return {kIndent + 150, heightForWidth(QWIDGETSIZE_MAX)}; }
    int heightForWidth(int width) const override {
      const int lines = fontMetrics().height() + (note_.isEmpty() ? 0 : noteHeight(width - kIndent - kMargin) + 2);
      return std::max(kBadge, lines) + 16;
    }

   protected:
    void paintEvent(QPaintEvent* /*event*/) override {
      const Colors& colors = Colors::of(palette());
      QPainter painter(this);
      painter.setRenderHint(QPainter::Antialiasing);
      if (open_ || underMouse()) painter.fillRect(rect(), colors.panel_active);
      if (hasFocus()) {
        painter.setPen(QPen(colors.accent, 2));
        painter.drawRoundedRect(rect().adjusted(2, 2, -2, -2), 4, 4);
      }
      paintBadge(painter, colors);
      const int width_left = width() - kIndent - kMargin;
      QFont bold = font();
      bold.setWeight(QFont::DemiBold);
      const QFontMetrics metrics(bold);
      painter.setFont(bold);
      painter.setPen(colors.text);
      const int top = note_.isEmpty() ? 8 + (kBadge - metrics.height()) / 2 : 8;
      painter.drawText(QRect(kIndent, top, width_left, metrics.height()), Qt::AlignLeft | Qt::AlignVCenter,
                       metrics.elidedText(title_, Qt::ElideRight, width_left));
      painter.setFont(font());
      painter.setPen(colors.text_muted);
      painter.drawText(QRect(kIndent, top + metrics.height() + 2, width_left, noteHeight(width_left)), kNoteFlags,
                       note_);
    }
    bool event(QEvent* event) override {
      // enterEvent has another argument in Qt 6.
      if (event->type() == QEvent::Enter || event->type() == QEvent::Leave) update();
      return QAbstractButton::event(event);
    }

   private:
    static constexpr int kNoteFlags = Qt::AlignLeft | Qt::AlignTop | Qt::TextWordWrap;

    int noteHeight(int width) const {
      return fontMetrics().boundingRect(QRect(0, 0, std::max(1, width), 10000), kNoteFlags, note_).height();
    }
    void paintBadge(QPainter& painter, const Colors& colors) const {
      const QRectF circle(kMargin + 0.5, 8.5, kBadge - 1, kBadge - 1);
      const bool waiting = state_ == StepState::Waiting;
      painter.setPen(waiting ? QPen(colors.border, 1.5) : QPen(Qt::NoPen));
      painter.setBrush(waiting ? QBrush(Qt::NoBrush) : QBrush(state_ == StepState::Done ? colors.good : colors.accent));
      painter.drawEllipse(circle);
      painter.setBrush(Qt::NoBrush);
      const QColor ink = waiting ? colors.text_muted : colors.accent_text;
      if (state_ == StepState::Done) {
        painter.setPen(QPen(ink, 2, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        const QPointF c = circle.center();
        const QPointF tick[] = {c + QPointF(-4.2, 0.3), c + QPointF(-1.2, 3.3), c + QPointF(4.4, -3.2)};
        painter.drawPolyline(tick, 3);
        return;
      }
      QFont bold = font();
      bold.setWeight(QFont::DemiBold);
      painter.setFont(bold);
      painter.setPen(ink);
      painter.drawText(circle, Qt::AlignCenter, QString::number(number_));
    }

    int number_;
    QString title_;
    QString note_;
    StepState state_ = StepState::Waiting;
    bool open_ = false;
  };

  class Row : public QWidget {
   public:
    Row(int number, QWidget* parent) : QWidget(parent), head_(new StepHead(number, this)) {
      setObjectName(QStringLiteral("step%1").arg(number));
      head_->setObjectName(QStringLiteral("stepHead%1").arg(number));
      because_->setObjectName(QStringLiteral("stepBecause%1").arg(number));
      auto* body = spaced(new QVBoxLayout(body_), {kMargin + 6, 2, kMargin, 14}, 8);
      addWidgets(body, {what_, why_, because_});
      body->addLayout(content_);
      body->addLayout(buttons_);
      auto* layout = spaced(new QVBoxLayout(this), {0, 0, 0, 0}, 0);
      addWidgets(layout, {head_, body_});
    }

    void set(const Step& step) {
      head_->set(step);
      showIfAny(what_, unbroken(step.what));
      showIfAny(why_, step.why);
      because_->setText(readinessText(step.readiness).arg(step.because));
      because_->setVisible(!step.because.isEmpty());
      while (buttons_shown_.size() < step.actions.size()) {
        auto* button = quiet(new ActionButton(body_), "stepButton");
        buttons_->addWidget(button);
        buttons_shown_.push_back(button);
      }
      giveRoom();
      for (std::size_t k = 0; k < buttons_shown_.size(); ++k) {
        buttons_shown_[k]->setAction(k < step.actions.size() ? step.actions[k] : nullptr);
      }
    }
    void setContent(QWidget* content) { content_->addWidget(content); }
    void setOpen(bool open) {
      body_->setVisible(open);
      head_->setOpen(open);
    }
    [[nodiscard]] QAbstractButton* head() const { return head_; }

   protected:
    void resizeEvent(QResizeEvent* event) override {
      giveRoom();
      QWidget::resizeEvent(event);
    }

   private:
    void giveRoom() {
      const QMargins margins = body_->layout()->contentsMargins();
      for (ActionButton* button : buttons_shown_) button->setRoom(width() - margins.left() - margins.right());
    }

    StepHead* head_;
    QFrame* body_ = styledAs(new QFrame(this), "stepBody");
    QLabel* what_ = styledAs(paragraph("stepWhat", body_), "stepWhat");
    QLabel* why_ = styledAs(paragraph("stepWhy", body_), "muted");
    QLabel* because_ = paragraph("stepBecause", body_);
    QVBoxLayout* content_ = new QVBoxLayout;
    FlowLayout* buttons_ = new FlowLayout;
    std::vector<ActionButton*> buttons_shown_;
  };
};

}  // namespace hexoderm
