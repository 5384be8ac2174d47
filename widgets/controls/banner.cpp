#include "widgets/controls/banner.h"

#include "widgets/controls/action_button.h"
#include "widgets/controls/elided_label.h"
#include "widgets/controls/panel_parts.h"
#include "widgets/style/of_enum.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QStyle>
#include <QVariant>
#include <array>

namespace hexoderm {

Tone toneOf(VerdictLevel level) { return ofEnum(level, {Tone::Good, Tone::Caution, Tone::Caution, Tone::Bad}); }

Tone toneOf(Severity severity) { return ofEnum(severity, {Tone::Neutral, Tone::Caution, Tone::Bad}); }

QString toneSign(Tone tone) {
  return ofEnum(tone, {QStringLiteral("●"), QStringLiteral("✓"), QStringLiteral("▲"), QStringLiteral("✕")});
}

QColor toneColor(Tone tone, Theme theme) {
  const Colors& colors = Colors::of(theme);
  return ofEnum(tone, {colors.text_muted, colors.good, colors.caution, colors.bad});
}

void setTone(QLabel* label, Tone tone) {
  constexpr std::array kNames = {"neutral", "good", "caution", "bad"};
  const QString name = QLatin1String(kNames.at(static_cast<std::size_t>(tone)));
  if (label->property("tone").toString() == name) return;
  label->setProperty("tone", name);
  label->style()->polish(label);
}

Banner::Banner(QWidget* parent)
    : QFrame(parent),
      dot_(new QLabel(this)),
      sentence_(new ElidedLabel(2, this)),
      button_(quiet(new ActionButton(this), "bannerButton")) {
  setNames(this, QStringLiteral("banner"), tr("Where we stand"));
  setProperty("banner", true);

  dot_->setProperty("dot", true);
  constexpr int kDot = 14;
  dot_->setFixedSize(kDot, kDot);
  sentence_->setObjectName(QStringLiteral("bannerSentence"));
  sentence_->setProperty("headline", true);
  button_->setProperty("primary", true);

  auto* layout = spaced(new QHBoxLayout(this), {16, 6, 16, 6}, 14);
  layout->addWidget(dot_);
  layout->addWidget(sentence_, 1);
  layout->addWidget(button_);
}

void Banner::setContent(const Content& content) {
  setTone(dot_, content.tone);
  sentence_->setText(content.sentence);
  button_->setAction(content.action);
}

}  // namespace hexoderm
