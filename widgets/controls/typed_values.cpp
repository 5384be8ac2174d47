#include "widgets/controls/typed_values.h"

#include <QAbstractSpinBox>
#include <QKeyEvent>

namespace hexoderm {
namespace {

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

}  // namespace

void letTypingReplaceSpecialText(QAbstractSpinBox* field) { new SpecialTextReplacer(field); }

}  // namespace hexoderm
