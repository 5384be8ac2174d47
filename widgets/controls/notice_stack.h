#pragma once

#include <QWidget>

namespace hexoderm {

/// Notices that lie over the content instead of pushing it: one above the other, at the bottom of another widget and in
/// its middle. Takes no room while none of them is shown.
class NoticeStack : public QWidget {
  Q_OBJECT

 public:
  /// Lies over `host`, which owns it.
  explicit NoticeStack(QWidget* host);

  /// Takes over a notice, which is shown and hidden by whoever has something to say.
  void add(QWidget* notice);

 protected:
  bool event(QEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void place();

  QList<QWidget*> notices_;
};

}  // namespace hexoderm
