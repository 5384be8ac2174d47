#include "widgets/live_strip.h"

#include "widgets/action_button.h"
#include "widgets/core_words.h"

#include <QAction>
#include <QCheckBox>
#include <QCoreApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QProgressBar>
#include <QVBoxLayout>
#include <QVariant>

namespace hexoderm {
namespace {

struct LiveWords {
  Q_DECLARE_TR_FUNCTIONS(hexoderm::LiveWords)
};

constexpr int kProgressSteps = 100;

QLabel* plainLabel(const char* object_name, QWidget* parent) {
  auto* label = new QLabel(parent);
  label->setObjectName(QLatin1String(object_name));
  // What devices say of themselves is never read as markup.
  label->setTextFormat(Qt::PlainText);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  return label;
}

ActionButton* buttonFor(QAction* action, const char* object_name, QWidget* parent) {
  auto* button = new ActionButton(parent);
  button->setObjectName(QLatin1String(object_name));
  button->setAction(action);
  // A click leaves the keys where they were.
  button->setFocusPolicy(Qt::TabFocus);
  return button;
}

void setIfChanged(QLabel* label, const QString& text) {
  if (label->text() != text) label->setText(text);
}

}  // namespace

QString sourceStateWord(SourceState state) {
  switch (state) {
    case SourceState::Stopped:
      return LiveWords::tr("Stopped");
    case SourceState::Connecting:
      return LiveWords::tr("Connecting");
    case SourceState::Waiting:
      return LiveWords::tr("Waiting");
    case SourceState::Streaming:
      return LiveWords::tr("Streaming");
    case SourceState::Silent:
      return LiveWords::tr("Silent");
    case SourceState::Ended:
      return LiveWords::tr("Ended");
    case SourceState::Incompatible:
      return LiveWords::tr("Incompatible");
  }
  return {};
}

QString sourceStateSign(SourceState state) {
  switch (state) {
    case SourceState::Stopped:
      return QStringLiteral("\u25CB");  // circle
    case SourceState::Connecting:
      return QStringLiteral("\u25D4");  // quarter of a disc
    case SourceState::Waiting:
      return QStringLiteral("\u25D1");  // half a disc
    case SourceState::Streaming:
      return QStringLiteral("\u25CF");  // disc
    case SourceState::Silent:
      return QStringLiteral("\u25B2");  // triangle
    case SourceState::Ended:
      return QStringLiteral("\u25A0");  // square
    case SourceState::Incompatible:
      return QStringLiteral("\u2715");  // cross
  }
  return {};
}

Tone sourceStateTone(SourceState state) {
  switch (state) {
    case SourceState::Streaming:
      return Tone::Good;
    case SourceState::Silent:
      return Tone::Caution;
    case SourceState::Incompatible:
      return Tone::Bad;
    case SourceState::Stopped:
    case SourceState::Connecting:
    case SourceState::Waiting:
    case SourceState::Ended:
      return Tone::Neutral;
  }
  return Tone::Neutral;
}

QString countersInWords(const SourceStatus& status, const HoldStatus& hold) {
  const auto number = [](std::uint64_t count) { return QLocale().toString(static_cast<qulonglong>(count)); };
  QString text =
      LiveWords::tr("%1 frames · %2 lost · %3 late")
          .arg(number(status.frames), number(status.lost_samples), number(status.late_frames + hold.late_frames));
  if (status.rejected_messages > 0) text += LiveWords::tr(" · %1 broken").arg(number(status.rejected_messages));
  if (status.unknown_samples > 0) text += LiveWords::tr(" · %1 unknown").arg(number(status.unknown_samples));
  if (status.reconnects > 0) text += LiveWords::tr(" · %1 reconnects").arg(number(status.reconnects));
  return text;
}

LiveStrip::LiveStrip(QAction* automatic, QAction* capture, QAction* end, QWidget* parent)
    : QFrame(parent),
      sign_(plainLabel("liveSign", this)),
      word_(plainLabel("liveState", this)),
      text_(plainLabel("liveText", this)),
      counters_(plainLabel("liveCounters", this)),
      capture_row_(new QWidget(this)),
      progress_(new QProgressBar(capture_row_)),
      hold_(plainLabel("liveHold", capture_row_)),
      automatic_(new QCheckBox(capture_row_)) {
  setObjectName(QStringLiteral("liveStrip"));
  setAccessibleName(tr("Connected skin"));
  setProperty("card", true);
  word_->setProperty("headline", true);
  hold_->setProperty("headline", true);
  counters_->setProperty("muted", true);
  counters_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  // Counting does not move what is beside it.
  counters_->setMinimumWidth(fontMetrics().horizontalAdvance(QStringLiteral("0,000,000 frames · 000 lost · 000 late")));
  counters_->setToolTip(
      tr("Sample frames that came, samples that the device numbered and that never came, and frames that came late"));
  // A long text must not widen the window.
  for (QLabel* label : {text_, hold_}) {
    label->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    label->setWordWrap(true);
  }
  progress_->setObjectName(QStringLiteral("liveProgress"));
  progress_->setAccessibleName(tr("How long the part has been held"));
  progress_->setRange(0, kProgressSteps);
  progress_->setTextVisible(false);
  progress_->setFixedWidth(150);
  automatic_->setObjectName(QStringLiteral("liveAutomatic"));
  automatic_->setFocusPolicy(Qt::TabFocus);
  connect(automatic_, &QCheckBox::clicked, automatic, [automatic] { automatic->trigger(); });
  const auto follow = [this, automatic] {
    automatic_->setText(automatic->iconText());
    automatic_->setChecked(automatic->isChecked());
    automatic_->setEnabled(automatic->isEnabled());
    automatic_->setToolTip(automatic->toolTip());
  };
  connect(automatic, &QAction::changed, this, follow);
  follow();

  auto* state_row = new QHBoxLayout;
  state_row->setSpacing(10);
  state_row->addWidget(sign_);
  state_row->addWidget(word_);
  state_row->addWidget(text_, 1);
  state_row->addWidget(counters_);
  state_row->addWidget(buttonFor(end, "liveDisconnect", this));
  auto* capture_row = new QHBoxLayout(capture_row_);
  capture_row->setContentsMargins(0, 0, 0, 0);
  capture_row->setSpacing(12);
  capture_row->addWidget(progress_);
  capture_row->addWidget(hold_, 1);
  capture_row->addWidget(automatic_);
  capture_row->addWidget(buttonFor(capture, "liveCapture", capture_row_));
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(14, 8, 10, 8);
  layout->setSpacing(6);
  layout->addLayout(state_row);
  layout->addWidget(capture_row_);
  hide();
}

void LiveStrip::setStatus(const SourceStatus& status, const HoldStatus& hold, bool is_capturing) {
  state_ = status.state;
  setIfChanged(sign_, sourceStateSign(state_));
  setIfChanged(word_, sourceStateWord(state_));
  // "Streaming: my skin" would say it twice.
  QString text = coreWords(status.text);
  const QString again = word_->text() + QStringLiteral(": ");
  if (text.startsWith(again)) text.remove(0, again.size());
  setIfChanged(text_, text);
  setIfChanged(counters_, countersInWords(status, hold));
  const bool is_streaming = state_ == SourceState::Streaming;
  capture_row_->setVisible(is_capturing);
  progress_->setValue(is_streaming ? static_cast<int>(kProgressSteps * hold.progress) : 0);
  // What was said of the last reading is no longer true when none come.
  setIfChanged(hold_, is_streaming ? coreWords(hold.text) : tr("No readings; what was captured stays"));
  paintSign();
}

void LiveStrip::setTheme(Theme theme) {
  theme_ = theme;
  paintSign();
}

void LiveStrip::paintSign() {
  QPalette colors = sign_->palette();
  const QColor color = toneColor(sourceStateTone(state_), theme_);
  if (colors.color(QPalette::WindowText) == color) return;
  colors.setColor(QPalette::WindowText, color);
  sign_->setPalette(colors);
}

}  // namespace hexoderm
