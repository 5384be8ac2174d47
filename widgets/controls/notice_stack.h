#pragma once

#include "widgets/controls/panel_parts.h"

#include <QEvent>
#include <QVBoxLayout>
#include <QVariant>
#include <QWidget>
#include <algorithm>

namespace hexoderm {

/// Notices that lie over the content instead of pushing it: one above the other, at the bottom of another widget and in
/// its middle. Takes no room while none of them is shown.
class NoticeStack : public QWidget {
  Q_OBJECT

 public:
  /// Lies over `host`, which owns it.
  explicit NoticeStack(QWidget* host) : QWidget(host) {
    setObjectName(QStringLiteral("noticeStack"));
    spaced(new QVBoxLayout(this), {0, 0, 0, 0}, 6);
    host->installEventFilter(this);
    hide();
  }

  /// Takes over a notice, which is shown and hidden by whoever has something to say.
  void add(QWidget* notice) {
    notice->setProperty("notice", true);
    layout()->addWidget(notice);
    notices_ << notice;
    notice->installEventFilter(this);
    place();
  }

 protected:
  bool event(QEvent* event) override {
    const bool taken = QWidget::event(event);
    if (event->type() == QEvent::LayoutRequest) place();
    return taken;
  }

  bool eventFilter(QObject* watched, QEvent* event) override {
    const QEvent::Type type = event->type();
    const bool is_host = watched == parentWidget();
    if (is_host ? type == QEvent::Resize || type == QEvent::Show
                : type == QEvent::ShowToParent || type == QEvent::HideToParent) {
      place();
    }
    return QWidget::eventFilter(watched, event);
  }

 private:
  void place() {
    const bool any =
        std::any_of(notices_.begin(), notices_.end(), [](const QWidget* notice) { return !notice->isHidden(); });
    setVisible(any);
    if (!any) return;
    constexpr int kMargin = 16;
    constexpr int kMaxCharacters = 110;  // longer lines are hard to read
    const QSize room = parentWidget()->size();
    const int width = std::min(room.width() - 2 * kMargin, kMaxCharacters * fontMetrics().averageCharWidth());
    layout()->activate();
    const int height =
        layout()->hasHeightForWidth() ? layout()->totalHeightForWidth(width) : layout()->totalSizeHint().height();
    setGeometry((room.width() - width) / 2, room.height() - height - kMargin, width, height);
    raise();
  }

  QList<QWidget*> notices_;
};

}  // namespace hexoderm
