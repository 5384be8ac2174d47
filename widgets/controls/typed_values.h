#pragma once

#include <QAbstractSpinBox>
#include <QKeyEvent>

namespace hexoderm {

class SpecialTextReplacer : public QObject {
 public:
  explicit SpecialTextReplacer(QAbstractSpinBox* field) : QObject(field), field_(field) {
    field->installEventFilter(this);
  }

  bool eventFilter(QObject* /*watched*/, QEvent* event) override {
    if (event->type() != QEvent::KeyPress || field_->specialValueText().isEmpty()) return false;
    const QString typed = static_cast<QKeyEvent*>(event)->text();
    const bool is_text = !typed.isEmpty() && typed.front().isPrint();
    if (is_text && field_->text() == field_->specialValueText()) field_->selectAll();
    return false;
  }

 private:
  QAbstractSpinBox* field_;
};

/// A field with a text for a special value ("not known") takes what is typed in place of that text. Qt's own would look
/// for a number in both together, find none, and ignore every key.
inline void letTypingReplaceSpecialText(QAbstractSpinBox* field) { new SpecialTextReplacer(field); }

}  // namespace hexoderm
