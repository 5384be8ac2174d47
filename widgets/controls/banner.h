#pragma once

#include "widgets/controls/action_button.h"
#include "widgets/controls/elided_label.h"
#include "widgets/controls/panel_parts.h"
#include "widgets/style/of_enum.h"
#include "widgets/style/palette.h"

#include <QFrame>
#include <QHBoxLayout>
#include <QLabel>
#include <QStyle>
#include <QVariant>
#include <array>

namespace hexoderm {

/// The quality of a message, good or bad; its words express it too.
enum class Tone { Neutral, Good, Caution, Bad };
inline QColor toneColor(Tone tone, Theme theme) {
  const Colors& colors = Colors::of(theme);
  return ofEnum(tone, {colors.text_muted, colors.good, colors.caution, colors.bad});
}
inline Tone toneOf(VerdictLevel level) {
  return ofEnum(level, {Tone::Good, Tone::Caution, Tone::Caution, Tone::Caution, Tone::Bad, Tone::Bad});
}
inline Tone toneOf(Severity severity) { return ofEnum(severity, {Tone::Neutral, Tone::Caution, Tone::Bad}); }
/// A sign of its own for each tone, so that no meaning hangs on hue.
inline QString toneSign(Tone tone) {
  return ofEnum(tone, {QStringLiteral("●"), QStringLiteral("✓"), QStringLiteral("▲"), QStringLiteral("✕")});
}
/// The style sheet writes the label in the tone's colour.
inline void setTone(QLabel* label, Tone tone) {
  constexpr std::array kNames = {"neutral", "good", "caution", "bad"};
  const QString name = QLatin1String(kNames.at(static_cast<std::size_t>(tone)));
  if (label->property("tone").toString() == name) return;
  label->setProperty("tone", name);
  label->style()->polish(label);
}

/// One sentence on where we stand and one button: the best next action. As high as two lines, whatever it says.
class Banner : public QFrame {
  Q_OBJECT

 public:
  explicit Banner(QWidget* parent = nullptr) : QFrame(parent) {
    setNames(this, QStringLiteral("banner"), tr("Where we stand"));
    setProperty("banner", true);

    constexpr int kDot = 14;
    dot_->setFixedSize(kDot, kDot);

    auto* layout = spaced(new QHBoxLayout(this), {16, 6, 16, 6}, 14);
    layout->addWidget(dot_);
    layout->addWidget(sentence_, 1);
    layout->addWidget(button_);
  }

  struct Content {
    Tone tone = Tone::Neutral;
    QString sentence;
    QAction* action = nullptr;  ///< null: there is nothing to press
  };
  void setContent(const Content& content) {
    setTone(dot_, content.tone);
    sentence_->setText(content.sentence);
    button_->setAction(content.action);
  }

 private:
  QLabel* dot_ = styledAs(new QLabel(this), "dot");
  ElidedLabel* sentence_ = styledAs(named(new ElidedLabel(2, this), "bannerSentence"), "headline");
  ActionButton* button_ = styledAs(quiet(new ActionButton(this), "bannerButton"), "primary");
};

}  // namespace hexoderm
