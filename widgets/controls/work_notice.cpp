#include "widgets/controls/work_notice.h"

#include "widgets/controls/panel_parts.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>

namespace hexoderm {

WorkNotice::WorkNotice(QWidget* parent) : QFrame(parent), cancel_(new QPushButton(tr("Cancel"), this)) {
  setNames(this, QStringLiteral("workNotice"), tr("Work that takes a while"));
  text_->setObjectName(QStringLiteral("workText"));
  setPlainParagraph(text_);
  bar_->setTextVisible(false);
  bar_->setAccessibleName(tr("Progress"));
  bar_->setFixedWidth(14 * fontMetrics().averageCharWidth());
  cancel_->setObjectName(QStringLiteral("workCancel"));
  cancel_->setToolTip(tr("Stop this; what is shown stays as it was before"));
  // A click leaves the keys where they were.
  cancel_->setFocusPolicy(Qt::TabFocus);
  connect(cancel_, &QPushButton::clicked, this, &WorkNotice::cancelled);
  auto* layout = spaced(new QHBoxLayout(this), {16, 6, 8, 6}, 12);
  layout->addWidget(text_, 1);
  addWidgets(layout, {bar_, cancel_});
  hide();
}

void WorkNotice::showWork(const QString& what, int done, int total) {
  if (text_->text() != what) text_->setText(what);
  const int most = total < 2 ? 0 : total;
  if (bar_->maximum() != most) bar_->setRange(0, most);
  if (most > 0) bar_->setValue(done);
  show();
}

QString WorkNotice::text() const { return text_->text(); }

}  // namespace hexoderm
