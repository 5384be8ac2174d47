#pragma once

#include "widgets/controls/panel_parts.h"

#include <QFrame>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>

namespace hexoderm {

/// A notice of work that takes long: what is being done, how far it is, and a button that gives it up.
class WorkNotice : public QFrame {
  Q_OBJECT

 public:
  explicit WorkNotice(QWidget* parent = nullptr) : QFrame(parent) {
    setNames(this, QStringLiteral("workNotice"), tr("Work that takes a while"));
    bar_->setTextVisible(false);
    bar_->setAccessibleName(tr("Progress"));
    bar_->setFixedWidth(14 * fontMetrics().averageCharWidth());
    cancel_->setToolTip(tr("Stop this; what is shown stays as it was before"));
    connect(cancel_, &QPushButton::clicked, this, &WorkNotice::cancelled);
    auto* layout = spaced(new QHBoxLayout(this), {16, 6, 8, 6}, 12);
    layout->addWidget(text_, 1);
    addWidgets(layout, {bar_, cancel_});
    hide();
  }

  /// `done` of `total` parts; a total below 2: nobody knows how far it is.
  void showWork(const QString& what, int done, int total) {
    text_->setText(what);
    const int most = total < 2 ? 0 : total;
    if (bar_->maximum() != most) bar_->setRange(0, most);
    if (most > 0) bar_->setValue(done);
    show();
  }

  [[nodiscard]] QString text() const { return text_->text(); }

 signals:
  void cancelled();

 private:
  QLabel* text_ = paragraph("workText", this);
  QProgressBar* bar_ = new QProgressBar(this);
  QPushButton* cancel_ = quiet(new QPushButton(tr("Cancel"), this), "workCancel");
};

}  // namespace hexoderm
