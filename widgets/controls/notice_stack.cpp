#include "widgets/controls/notice_stack.h"

#include <QEvent>
#include <QVBoxLayout>
#include <QVariant>
#include <algorithm>

namespace hexoderm {

NoticeStack::NoticeStack(QWidget* host) : QWidget(host) {
  setObjectName(QStringLiteral("noticeStack"));
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(6);
  host->installEventFilter(this);
  hide();
}

void NoticeStack::add(QWidget* notice) {
  notice->setProperty("notice", true);
  layout()->addWidget(notice);
  notices_ << notice;
  notice->installEventFilter(this);
  place();
}

bool NoticeStack::event(QEvent* event) {
  const bool taken = QWidget::event(event);
  if (event->type() == QEvent::LayoutRequest) place();
  return taken;
}

bool NoticeStack::eventFilter(QObject* watched, QEvent* event) {
  const QEvent::Type type = event->type();
  const bool is_host = watched == parentWidget();
  if (is_host ? type == QEvent::Resize || type == QEvent::Show
              : type == QEvent::ShowToParent || type == QEvent::HideToParent) {
    place();
  }
  return QWidget::eventFilter(watched, event);
}

void NoticeStack::place() {
  const bool any =
      std::any_of(notices_.begin(), notices_.end(), [](const QWidget* notice) { return !notice->isHidden(); });
  setVisible(any);
  if (!any) return;
  constexpr int kMargin = 16;
  constexpr int kMostCharacters = 110;  // longer lines are hard to read
  const QSize room = parentWidget()->size();
  const int width = std::min(room.width() - 2 * kMargin, kMostCharacters * fontMetrics().averageCharWidth());
  layout()->activate();
  const int height =
      layout()->hasHeightForWidth() ? layout()->totalHeightForWidth(width) : layout()->totalSizeHint().height();
  setGeometry((room.width() - width) / 2, room.height() - height - kMargin, width, height);
  raise();
}

}  // namespace hexoderm
