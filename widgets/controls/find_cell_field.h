#pragma once

#include "hexoderm/base/ids.h"
#include "widgets/controls/panel_parts.h"

#include <QFrame>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QRegularExpressionValidator>
#include <functional>
#include <utility>

namespace hexoderm {

/// The small field in which the ID of a cell is typed: it appears when it is needed and goes when it is done.
class FindCellField : public QFrame {
  Q_OBJECT

 public:
  /// `exists` says whether there is such a cell.
  FindCellField(std::function<bool(CellId)> exists, QWidget* parent) : QFrame(parent), exists_(std::move(exists)) {
    setObjectName(QStringLiteral("findCell"));
    setProperty("card", true);
    setAutoFillBackground(true);
    field_->setPlaceholderText(tr("Find cell…"));
    field_->setAccessibleName(tr("ID of the cell to find"));
    field_->setMaxLength(10);
    field_->setFixedWidth(field_->fontMetrics().horizontalAdvance(field_->placeholderText()) + 40);
    field_->setValidator(new QRegularExpressionValidator(QRegularExpression(QStringLiteral("[0-9]*")), field_));
    field_->installEventFilter(this);
    answer_->hide();
    auto* row = spaced(new QHBoxLayout(this), {5, 5, 5, 5}, 6);
    addWidgets(row, {field_, answer_});
    connect(field_, &QLineEdit::textChanged, this, &FindCellField::look);
    connect(field_, &QLineEdit::returnPressed, this, &FindCellField::finish);
    hide();
  }

  /// Shows the field with `text` as its beginning.
  void open(const QString& text) {
    show();
    raise();
    field_->setFocus(Qt::ShortcutFocusReason);
    field_->setText(text);
    look();
    adjustSize();
  }

 signals:
  /// While typing, each time the digits name a cell.
  void found(quint32 cell);
  void closed();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override {
    if (watched != field_) return QFrame::eventFilter(watched, event);
    const auto isEscape = [event] { return static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape; };
    switch (event->type()) {
      case QEvent::ShortcutOverride:  // or a shortcut of the window would take the key
        if (isEscape()) event->accept();
        break;
      case QEvent::KeyPress:
        if (isEscape()) {
          finish();
          return true;
        }
        break;
      case QEvent::FocusOut: {
        const Qt::FocusReason reason = static_cast<QFocusEvent*>(event)->reason();
        if (reason == Qt::MouseFocusReason || reason == Qt::TabFocusReason) finish();
        break;
      }
      default:
        break;
    }
    return QFrame::eventFilter(watched, event);
  }

 private:
  void look() {
    bool is_number = false;
    const quint32 id = field_->text().toUInt(&is_number);
    const bool there_is = is_number && exists_(CellId(id));
    showIfAny(answer_, there_is || field_->text().isEmpty() ? QString() : tr("no such cell"));
    adjustSize();
    if (there_is) emit found(id);
  }

  void finish() {
    if (isHidden()) return;
    hide();
    field_->clear();
    emit closed();
  }

  std::function<bool(CellId)> exists_;
  QLineEdit* field_ = new QLineEdit(this);
  QLabel* answer_ = styledAs(new QLabel(this), "muted");
};

}  // namespace hexoderm
