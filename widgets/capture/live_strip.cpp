#include "widgets/capture/live_strip.h"

#include "widgets/controls/action_button.h"
#include "widgets/controls/panel_parts.h"
#include "widgets/style/of_enum.h"
#include "widgets/words/words.h"

#include <QAction>
#include <QCoreApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QStringList>

namespace hexoderm {
namespace {

struct LiveWords {
  Q_DECLARE_TR_FUNCTIONS(hexoderm::LiveWords)
};

QLabel* plainLabel(const char* object_name, QWidget* parent) {
  auto* label = named(new QLabel(parent), object_name);
  // A device's texts are never read as markup.
  label->setTextFormat(Qt::PlainText);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  return label;
}

QString countText(std::uint64_t count) { return QLocale().toString(static_cast<qulonglong>(count)); }

}  // namespace

QString sourceStateWord(SourceState state) {
  return ofEnum(state, {LiveWords::tr("Stopped"), LiveWords::tr("Connecting"), LiveWords::tr("Waiting"),
                        LiveWords::tr("Streaming"), LiveWords::tr("Silent"), LiveWords::tr("Ended"),
                        LiveWords::tr("Incompatible")});
}

QString sourceStateSign(SourceState state) {
  // Circle, quarter and half of a disc, disc, triangle, square, cross.
  return ofEnum(state,
                {QStringLiteral("\u25CB"), QStringLiteral("\u25D4"), QStringLiteral("\u25D1"), QStringLiteral("\u25CF"),
                 QStringLiteral("\u25B2"), QStringLiteral("\u25A0"), QStringLiteral("\u2715")});
}

Tone sourceStateTone(SourceState state) {
  return ofEnum(state,
                {Tone::Neutral, Tone::Neutral, Tone::Neutral, Tone::Good, Tone::Caution, Tone::Neutral, Tone::Bad});
}

QString countersText(const SourceStatus& status, const HoldStatus& hold) {
  QString text = LiveWords::tr("%1 frames · %2 lost · %3 late")
                     .arg(countText(status.frames), countText(status.lost_samples),
                          countText(status.late_frames + hold.late_frames));
  if (status.dropped_by_device > 0) {
    text += LiveWords::tr(" · %1 dropped by the device").arg(countText(status.dropped_by_device));
  }
  if (status.rejected_messages > 0) text += LiveWords::tr(" · %1 broken").arg(countText(status.rejected_messages));
  if (status.unknown_samples > 0) text += LiveWords::tr(" · %1 unknown").arg(countText(status.unknown_samples));
  if (status.reconnects > 0) text += LiveWords::tr(" · %1 reconnects").arg(countText(status.reconnects));
  return text;
}

QString lossesText(const SourceStatus& status, const HoldStatus& hold) {
  QStringList losses;
  const auto add = [&losses](std::uint64_t count, const QString& one, const QString& several) {
    if (count == 1) losses << one;
    if (count > 1) losses << several.arg(countText(count));
  };
  add(status.lost_samples, LiveWords::tr("1 sample lost"), LiveWords::tr("%1 samples lost"));
  add(status.late_frames + hold.late_frames, LiveWords::tr("1 frame late"), LiveWords::tr("%1 frames late"));
  add(status.dropped_by_device, LiveWords::tr("1 sample dropped by the device"),
      LiveWords::tr("%1 samples dropped by the device"));
  return losses.join(QStringLiteral(" · "));
}

LiveStrip::LiveStrip(QAction* end, QWidget* parent)
    : QFrame(parent),
      sign_(plainLabel("liveSign", this)),
      word_(plainLabel("liveState", this)),
      text_(plainLabel("liveText", this)),
      counters_(plainLabel("liveCounters", this)) {
  setNames(this, QStringLiteral("liveStrip"), tr("Connected skin"));
  setProperty("card", true);
  word_->setProperty("headline", true);
  counters_->setProperty("muted", true);
  counters_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  // Counting does not move what is beside it.
  counters_->setMinimumWidth(fontMetrics().horizontalAdvance(QStringLiteral("0,000,000 frames · 000 lost · 000 late")));
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

void LiveStrip::setStatus(const SourceStatus& status, const HoldStatus& hold) {
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

}  // namespace hexoderm
