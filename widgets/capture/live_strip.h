#pragma once

#include "hexoderm/capture/pose_recorder.h"
#include "hexoderm/device/skin_source.h"
#include "widgets/controls/action_button.h"
#include "widgets/controls/banner.h"
#include "widgets/controls/panel_parts.h"
#include "widgets/style/of_enum.h"
#include "widgets/words/words.h"

#include <QAction>
#include <QCoreApplication>
#include <QFrame>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QStringList>

namespace hexoderm {

struct LiveWords {
  Q_DECLARE_TR_FUNCTIONS(hexoderm::LiveWords)

 public:
  static QString countText(std::uint64_t count) { return QLocale().toString(static_cast<qulonglong>(count)); }
};

/// "Streaming", "Silent", ...: one word for where a source stands (translated).
inline QString sourceStateWord(SourceState state) {
  return ofEnum(state, {LiveWords::tr("Stopped"), LiveWords::tr("Connecting"), LiveWords::tr("Waiting"),
                        LiveWords::tr("Streaming"), LiveWords::tr("Silent"), LiveWords::tr("Ended"),
                        LiveWords::tr("Incompatible")});
}
/// A sign of its own for each state, so that no meaning hangs on hue.
inline QString sourceStateSign(SourceState state) {
  // Circle, quarter and half of a disc, disc, triangle, square, cross.
  return ofEnum(state,
                {QStringLiteral("\u25CB"), QStringLiteral("\u25D4"), QStringLiteral("\u25D1"), QStringLiteral("\u25CF"),
                 QStringLiteral("\u25B2"), QStringLiteral("\u25A0"), QStringLiteral("\u2715")});
}
inline Tone sourceStateTone(SourceState state) {
  return ofEnum(state,
                {Tone::Neutral, Tone::Neutral, Tone::Neutral, Tone::Good, Tone::Caution, Tone::Neutral, Tone::Bad});
}
/// "17,230 frames · 0 lost · 0 late"; what else went wrong is added where there is any.
inline QString countersText(const SourceStatus& status, const HoldStatus& hold) {
  QString text = LiveWords::tr("%1 frames · %2 lost · %3 late")
                     .arg(LiveWords::countText(status.frames), LiveWords::countText(status.lost_samples),
                          LiveWords::countText(status.late_frames + hold.late_frames));
  if (status.dropped_by_device > 0) {
    text += LiveWords::tr(" · %1 dropped by the device").arg(LiveWords::countText(status.dropped_by_device));
  }
  if (status.rejected_messages > 0)
    text += LiveWords::tr(" · %1 broken").arg(LiveWords::countText(status.rejected_messages));
  if (status.unknown_samples > 0)
    text += LiveWords::tr(" · %1 unknown").arg(LiveWords::countText(status.unknown_samples));
  if (status.reconnects > 0) text += LiveWords::tr(" · %1 reconnects").arg(LiveWords::countText(status.reconnects));
  return text;
}

/// "12 samples lost · 3 frames late · 40 samples dropped by the device": what there is of that; empty: nothing.
inline QString lossesText(const SourceStatus& status, const HoldStatus& hold) {
  QStringList losses;
  const auto add = [&losses](std::uint64_t count, const QString& one, const QString& several) {
    if (count == 1) losses << one;
    if (count > 1) losses << several.arg(LiveWords::countText(count));
  };
  add(status.lost_samples, LiveWords::tr("1 sample lost"), LiveWords::tr("%1 samples lost"));
  add(status.late_frames + hold.late_frames, LiveWords::tr("1 frame late"), LiveWords::tr("%1 frames late"));
  add(status.dropped_by_device, LiveWords::tr("1 sample dropped by the device"),
      LiveWords::tr("%1 samples dropped by the device"));
  return losses.join(QStringLiteral(" · "));
}

/// The strip for a skin that does not (yet) send as it should: the state of its source, and a button that disconnects
/// it. The window shows it over the content until all is well; then the status bar and the step Capture say more.
class LiveStrip : public QFrame {
  Q_OBJECT

 public:
  /// `end`: what the button does.
  explicit LiveStrip(QAction* end, QWidget* parent = nullptr) : QFrame(parent) {
    setNames(this, QStringLiteral("liveStrip"), tr("Connected skin"));
    setProperty("card", true);
    counters_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    // Counting does not move what is beside it.
    counters_->setMinimumWidth(
        fontMetrics().horizontalAdvance(QStringLiteral("0,000,000 frames · 000 lost · 000 late")));
    counters_->setToolTip(
        tr("Sample frames that came, samples that the device numbered and that never came, and frames that came late"));
    // A long text must not widen the window.
    text_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    text_->setWordWrap(true);
    auto* disconnect = quiet(new ActionButton(this), "liveDisconnect");
    disconnect->setAction(end);
    auto* row = spaced(new QHBoxLayout(this), {14, 8, 10, 8}, 10);
    addWidgets(row, {sign_, word_});
    row->addWidget(text_, 1);
    addWidgets(row, {counters_, disconnect});
    hide();
  }

  void setStatus(const SourceStatus& status, const HoldStatus& hold) {
    sign_->setText(sourceStateSign(status.state));
    setTone(sign_, sourceStateTone(status.state));
    word_->setText(sourceStateWord(status.state));
    // "Streaming: my skin" would say it twice.
    QString text = words(status.message);
    const QString again = word_->text() + QStringLiteral(": ");
    if (text.startsWith(again)) text.remove(0, again.size());
    text_->setText(text);
    counters_->setText(countersText(status, hold));
  }

 private:
  static QLabel* plainLabel(const char* object_name, QWidget* parent) {
    auto* label = named(new QLabel(parent), object_name);
    // A device's texts are never read as markup.
    label->setTextFormat(Qt::PlainText);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    return label;
  }

  QLabel* sign_ = plainLabel("liveSign", this);
  QLabel* word_ = styledAs(plainLabel("liveState", this), "headline");
  QLabel* text_ = plainLabel("liveText", this);
  QLabel* counters_ = styledAs(plainLabel("liveCounters", this), "muted");
};

}  // namespace hexoderm
