#include "widgets/controls/work_notice.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>

namespace hexoderm {

WorkNotice::WorkNotice(QWidget* parent)
    : QFrame(parent),
      text_(new QLabel(this)),
      bar_(new QProgressBar(this)),
      cancel_(new QPushButton(tr("Cancel"), this)) {
  setObjectName(QStringLiteral("workNotice"));
  setAccessibleName(tr("Work that takes a while"));
  text_->setObjectName(QStringLiteral("workText"));
  text_->setTextFormat(Qt::PlainText);
  text_->setWordWrap(true);
  bar_->setTextVisible(false);
  bar_->setAccessibleName(tr("Progress"));
  bar_->setFixedWidth(14 * fontMetrics().averageCharWidth());
  cancel_->setObjectName(QStringLiteral("workCancel"));
  cancel_->setToolTip(tr("Stop this; what is shown stays as it was before"));
  // A click leaves the keys where they were.
  cancel_->setFocusPolicy(Qt::TabFocus);
  connect(cancel_, &QPushButton::clicked, this, &WorkNotice::cancelled);
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(16, 6, 8, 6);
  layout->setSpacing(12);
  layout->addWidget(text_, 1);
  layout->addWidget(bar_);
  layout->addWidget(cancel_);
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
