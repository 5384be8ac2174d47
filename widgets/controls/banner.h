#pragma once

#include "widgets/style/palette.h"

#include <QFrame>

class QAction;
class QLabel;

namespace hexoderm {

class ActionButton;
class ElidedLabel;

/// The quality of a message, good or bad; its words express it too.
enum class Tone { Neutral, Good, Caution, Bad };
QColor toneColor(Tone tone, Theme theme);
Tone toneOf(VerdictLevel level);
Tone toneOf(Severity severity);
/// A sign of its own for each tone, so that no meaning hangs on hue.
QString toneSign(Tone tone);
/// The style sheet writes the label in the tone's colour.
void setTone(QLabel* label, Tone tone);

/// One sentence on where we stand and one button: the best next action. As high as two lines, whatever it says.
class Banner : public QFrame {
  Q_OBJECT

 public:
  explicit Banner(QWidget* parent = nullptr);

  struct Content {
    Tone tone = Tone::Neutral;
    QString sentence;
    QAction* action = nullptr;  ///< null: there is nothing to press
  };
  void setContent(const Content& content);

 private:
  QLabel* dot_;
  ElidedLabel* sentence_;
  ActionButton* button_;
};

}  // namespace hexoderm
