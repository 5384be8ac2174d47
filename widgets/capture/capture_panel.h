#pragma once

#include "hexoderm/base/units.h"
#include "hexoderm/capture/pose_recorder.h"
#include "hexoderm/device/skin_source.h"
#include "hexoderm/solve/metrics/pose_coverage.h"
#include "widgets/capture/capture_words.h"
#include "widgets/capture/hold_ring.h"
#include "widgets/capture/live_strip.h"
#include "widgets/controls/action_button.h"
#include "widgets/controls/panel_parts.h"
#include "widgets/style/palette.h"
#include "widgets/words/formatting.h"
#include "widgets/words/words.h"

#include <QAction>
#include <QCheckBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QResizeEvent>
#include <QTimer>
#include <QVBoxLayout>
#include <QWidget>
#include <algorithm>
#include <cmath>
#include <optional>

class QBoxLayout;

namespace hexoderm {

/// A check box drawn as a switch: a mode that stays on, rather than a choice in a form.
class ToggleSwitch : public QCheckBox {
  Q_OBJECT

 public:
  using QCheckBox::QCheckBox;
  QSize sizeHint() const override {
    const int line = fontMetrics().height();
    return {static_cast<int>((1.8 + kSpace) * line) + fontMetrics().horizontalAdvance(text()) + 6,
            static_cast<int>(1.5 * line)};
  }

  QSize minimumSizeHint() const override { return sizeHint(); }

 protected:
  void paintEvent(QPaintEvent* /*event*/) override {
    const Colors& colors = Colors::of(palette());
    const double line = fontMetrics().height();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF track(2, 0.5 * (height() - 0.95 * line), 1.75 * line, 0.95 * line);
    const bool on = isChecked();
    painter.setPen(QPen(on && isEnabled() ? colors.accent : colors.excluded_link, 1.2));
    painter.setBrush(on ? (isEnabled() ? colors.accent : colors.excluded_link) : colors.panel);
    painter.drawRoundedRect(track, track.height() / 2, track.height() / 2);
    const double radius = 0.36 * line;
    const QPointF knob(on ? track.right() - track.height() / 2 : track.left() + track.height() / 2, track.center().y());
    painter.setPen(Qt::NoPen);
    painter.setBrush(on ? colors.panel : colors.excluded_link);
    painter.drawEllipse(knob, radius, radius);
    const QRectF label(track.right() + kSpace * line, 0, width() - track.right() - kSpace * line, height());
    painter.setPen(isEnabled() ? colors.text : colors.text_muted);
    painter.drawText(label, Qt::AlignLeft | Qt::AlignVCenter, text());
    if (hasFocus()) {
      painter.setPen(QPen(colors.text, 1.5));
      painter.setBrush(Qt::NoBrush);
      painter.drawRoundedRect(track.adjusted(-1.5, -1.5, 1.5, 1.5), track.height() / 2, track.height() / 2);
    }
  }

  bool hitButton(const QPoint& position) const override { return rect().contains(position); }

 private:
  static constexpr double kSpace = 0.6;  // between switch and text, in line heights
};

/// The operator's view of capturing: the next pose, readable from three metres, with its reason; the hold ring; the
/// condition that is awaited, with cell, value and limit; and the buttons for it. Without a source it says that no skin
/// is connected.
class CapturePanel : public QWidget {
  Q_OBJECT

 public:
  /// `automatic` can be checked: it becomes the switch. Null leaves a thing out. The actions must outlive the panel.
  struct Actions {
    QAction* automatic = nullptr;
    QAction* capture = nullptr;
    QAction* skip = nullptr;
    QAction* turn = nullptr;
  };

  explicit CapturePanel(const Actions& actions, QWidget* parent = nullptr) : QWidget(parent) {
    setNames(this, QStringLiteral("capturePanel"), tr("Capturing poses"));
    setUpOnce(captured_timer_, kCapturedShown_ms, this, [this] {
      captured_.reset();
      refresh();
    });

    auto* words = spaced(new QVBoxLayout, 6);
    for (QLabel* label : {what_, turn_, why_, sigma_}) words->addWidget(label);
    words->addStretch(1);
    auto* doing = spaced(new QVBoxLayout, 6);
    doing->addWidget(ring_);
    for (QLabel* label : {wait_, remark_, odd_}) doing->addWidget(label);
    if (actions.automatic) doing->addWidget(makeSwitch(actions.automatic), 0, Qt::AlignLeft);
    if (actions.capture) doing->addWidget(makeButton(actions.capture, "captureNow"), 0, Qt::AlignLeft);
    if (actions.turn) doing->addWidget(makeButton(actions.turn, "captureTurnForMe"), 0, Qt::AlignLeft);
    if (actions.skip) doing->addWidget(makeButton(actions.skip, "captureSkip"), 0, Qt::AlignLeft);
    doing->addStretch(1);
    spaced(columns_, {0, 0, 0, 0}, 8);
    columns_->addLayout(words, 1);
    columns_->addLayout(doing, 1);
    setSource(std::nullopt);
    refreshAdvice();
    fitText();
  }

  /// The state of the source; none: no skin is connected.
  void setSource(const std::optional<SourceStatus>& status) {
    source_ = status;
    if (!source_) writing_.reset();
    refresh();
    refreshAdvice();
  }

  /// Cheap: at most 20 times a second. Shown while the source streams.
  void setHold(const HoldStatus& hold) {
    // A figure that trembles with the hand can't be read, and would lay the panel out anew with every reading.
    const double moved_rad = hold_.stillness.moved_rad;
    const bool stays = hold.stillness.blocker == Blocker::NotMoved && hold_.stillness.blocker == Blocker::NotMoved &&
                       std::abs(hold.stillness.moved_rad - moved_rad) < kTremor_rad;
    hold_ = hold;
    if (stays) hold_.stillness.moved_rad = moved_rad;
    // A motion ends the moment of the capture.
    if (hold.stillness.armed && hold.progress > 0 && hold.phase == HoldPhase::Watching) {
      writing_.reset();
      captured_.reset();
    }
    refresh();
  }

  /// Nothing: advice is still being worked out.
  void setAdvice(const std::optional<NextPose>& next) {
    next_ = next;
    refreshAdvice();
  }

  /// The ring says that the pose is being written, until showCaptured() or a motion.
  void showWriting(PoseId pose) {
    writing_ = pose;
    captured_.reset();
    captured_timer_.stop();
    showIfAny(remark_, {});
    refresh();
  }

  /// The pose will not be written.
  void endWriting(PoseId pose) {
    if (writing_ == pose) writing_.reset();
    refresh();
  }

  /// The ring says for a moment that the pose is captured; `remark` ("Pose 4 repeats pose 2") stays until the next
  /// pose.
  void showCaptured(PoseId pose, const QString& remark = {}) {
    if (writing_ == pose) writing_.reset();
    captured_ = pose;
    showIfAny(remark_, remark);
    captured_timer_.start();
    refresh();
  }

  /// What the operator is to do or should know now, in one sentence for the ear; empty without a skin that sends.
  [[nodiscard]] QString instruction() const {
    if (!source_ || source_->state != SourceState::Streaming) return {};
    if (captured_) return tr("Pose %1 captured.").arg(captured_->value());
    if (!next_) return {};
    const bool is_there = next_->isWanted() && next_->turn_rad && *next_->turn_rad < kThere_rad;
    return is_there ? turnText(*next_) : nextPoseText(*next_);
  }

 signals:
  void instructionChanged(const QString& instruction);

 protected:
  void resizeEvent(QResizeEvent* event) override {
    QWidget::resizeEvent(event);
    fitText();
  }

  void changeEvent(QEvent* event) override {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::FontChange || event->type() == QEvent::StyleChange) fitText();
  }

 private:
  void refresh() {
    tellInstruction();
    ring_->setVisible(source_.has_value());
    if (!source_) {
      showIfAny(wait_, tr("No skin is connected, so no pose can be taken."));
      showIfAny(odd_, {});
      return;
    }
    if (source_->state != SourceState::Streaming) {
      // Statements about the last reading are no longer true when no readings come.
      ring_->setContent({sourceStateWord(source_->state), tr("no readings"), 0, false});
      showIfAny(wait_, words(source_->message));
      showIfAny(odd_, {});
      return;
    }
    if (captured_) {
      ring_->setContent({tr("Captured"), tr("pose %1").arg(captured_->value()), 1, true});
    } else if (writing_) {
      ring_->setContent({tr("Writing"), tr("pose %1").arg(writing_->value()), 1, false});
    } else {
      // An operator on the way to the next pose is not told to stop.
      const bool on_the_way = hold_.phase == HoldPhase::Watching && hold_.stillness.blocker == Blocker::Turning &&
                              next_ && next_->turn_rad && *next_->turn_rad > kOnTheWay;
      const HoldWords words =
          on_the_way ? HoldWords{tr("Keep turning"), tr("%1 to go").arg(turnAngleText(*next_))} : holdText(hold_);
      ring_->setContent({words.word, words.detail, on_the_way ? 0 : hold_.progress, false});
    }
    showIfAny(wait_, waitText(hold_));
    showIfAny(odd_, oddCellsText(hold_));
  }

  void refreshAdvice() {
    tellInstruction();
    const bool is_known = source_ && next_;
    showIfAny(what_, !source_ ? tr("No skin is connected.")
                     : next_  ? nextPoseText(*next_)
                              : tr("Working out which pose helps most…"));
    showIfAny(turn_, is_known ? turnText(*next_) : QString());
    showIfAny(why_, is_known ? gainText(*next_) : QString());
    showIfAny(sigma_, is_known ? unbroken(sigmaText(*next_)) : QString());
  }

  void tellInstruction() {
    const QString now = instruction();
    if (now == instruction_) return;
    instruction_ = now;
    emit instructionChanged(now);
  }

  void fitText() {
    const double line = fontMetrics().height();
    const bool beside = width() > kSideBySideAtLines * line;
    columns_->setDirection(beside ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
    for (int side : {0, 1}) columns_->setStretch(side, beside || side == 1 ? 1 : 0);
    const double room = beside ? 0.5 * width() : width();
    const double factor =
        std::clamp(kSmallestSentence * room / (kSmallestAtLines * line), kSmallestSentence, kLargestSentence);
    QFont large = font();
    large.setPointSizeF(factor * font().pointSizeF());
    if (turn_->font().pointSizeF() != large.pointSizeF()) turn_->setFont(large);
    large.setWeight(QFont::DemiBold);
    if (what_->font() != large) what_->setFont(large);
    // Two lines are kept, so that nothing below moves when the sentence gets longer.
    wait_->setMinimumHeight(static_cast<int>(2 * line));
    wait_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  }

  QBoxLayout* columns_ = new QBoxLayout(QBoxLayout::TopToBottom, this);
  QLabel* what_ = paragraph("captureWhat", this);
  QLabel* turn_ = paragraph("captureTurn", this);
  QLabel* why_ = styledAs(paragraph("captureWhy", this), "muted");
  QLabel* sigma_ = styledAs(paragraph("captureSigma", this), "muted");
  HoldRing* ring_ = new HoldRing(this);
  QLabel* wait_ = paragraph("captureWait", this);
  QLabel* odd_ = styledAs(paragraph("captureOdd", this), "muted");
  QLabel* remark_ = paragraph("captureRemark", this);
  QTimer captured_timer_;
  std::optional<SourceStatus> source_;
  HoldStatus hold_;
  std::optional<NextPose> next_;
  std::optional<PoseId> writing_;
  std::optional<PoseId> captured_;
  QString instruction_;  ///< as instructionChanged() last said

  static constexpr int kCapturedShown_ms = 2500;
  static constexpr double kOnTheWay = 20 * kDegree;
  static constexpr double kTremor_rad = 0.5 * kDegree;
  // Multiples of the usual font: the sentence is read from three metres, and is larger where there is room.
  static constexpr double kSmallestSentence = 1.6;
  static constexpr double kLargestSentence = 3.0;
  static constexpr double kSmallestAtLines = 24;  // width, in line heights, up to which it is the smallest
  static constexpr double kSideBySideAtLines = 40;

  static QWidget* makeSwitch(QAction* automatic) {
    auto* toggle = quiet(new ToggleSwitch, "captureAutomatic");
    QObject::connect(toggle, &QCheckBox::clicked, automatic, [automatic] { automatic->trigger(); });
    const auto follow = [toggle, automatic] {
      toggle->setText(automatic->iconText());
      toggle->setChecked(automatic->isChecked());
      toggle->setEnabled(automatic->isEnabled());
      toggle->setToolTip(automatic->toolTip());
      toggle->setAccessibleDescription(automatic->toolTip());
    };
    QObject::connect(automatic, &QAction::changed, toggle, follow);
    follow();
    return toggle;
  }

  /// The button with its key beside it.
  static QWidget* makeButton(QAction* action, const char* object_name) {
    auto* row = new QWidget;
    auto* button = quiet(new ActionButton(row), object_name);
    button->setAction(action);
    auto* key = styledAs(new QLabel(row), "muted");
    const auto follow = [key, action] {
      key->setText(action->shortcut().toString(QKeySequence::NativeText));
      key->setVisible(!action->shortcut().isEmpty());
    };
    QObject::connect(action, &QAction::changed, key, follow);
    follow();
    addWidgets(spaced(new QHBoxLayout(row), {0, 0, 0, 0}), {button, key});
    return row;
  }
};

}  // namespace hexoderm
