#include "widgets/controls/banner.h"

#include "widgets/controls/action_button.h"
#include "widgets/controls/elided_label.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPixmap>
#include <QVariant>

namespace hexoderm {

Tone toneOf(VerdictLevel level) {
  switch (level) {
    case VerdictLevel::Good:
      return Tone::Good;
    case VerdictLevel::Usable:
    case VerdictLevel::NotEnough:
      return Tone::Caution;
    case VerdictLevel::Failed:
      return Tone::Bad;
  }
  return Tone::Neutral;
}

QColor toneColor(Tone tone, Theme theme) {
  const Colors& colors = Colors::of(theme);
  switch (tone) {
    case Tone::Neutral:
      return colors.text_muted;
    case Tone::Good:
      return colors.good;
    case Tone::Caution:
      return colors.caution;
    case Tone::Bad:
      return colors.bad;
  }
  return colors.text_muted;
}

Banner::Banner(QWidget* parent)
    : QFrame(parent), dot_(new QLabel(this)), sentence_(new ElidedLabel(2, this)), button_(new ActionButton(this)) {
  setObjectName(QStringLiteral("banner"));
  setAccessibleName(tr("Where we stand"));
  setProperty("banner", true);

  sentence_->setObjectName(QStringLiteral("bannerSentence"));
  sentence_->setProperty("headline", true);
  button_->setObjectName(QStringLiteral("bannerButton"));
  button_->setProperty("primary", true);
  // A click leaves the keys where they were.
  button_->setFocusPolicy(Qt::TabFocus);

  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(16, 6, 16, 6);
  layout->setSpacing(14);
  layout->addWidget(dot_);
  layout->addWidget(sentence_, 1);
  layout->addWidget(button_);
  drawDot();
}

void Banner::setContent(const Content& content) {
  tone_ = content.tone;
  sentence_->setText(content.sentence);
  button_->setAction(content.action);
  drawDot();
}

void Banner::setTheme(Theme theme) {
  theme_ = theme;
  drawDot();
}

void Banner::drawDot() {
  constexpr int kSize = 14;
  const qreal ratio = devicePixelRatioF();
  QPixmap pixmap(QSize(kSize, kSize) * ratio);
  pixmap.setDevicePixelRatio(ratio);
  pixmap.fill(Qt::transparent);
  QPainter painter(&pixmap);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  painter.setBrush(toneColor(tone_, theme_));
  painter.drawEllipse(0, 0, kSize, kSize);
  painter.end();
  dot_->setPixmap(pixmap);
}

}  // namespace hexoderm
