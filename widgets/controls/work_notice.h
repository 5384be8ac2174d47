#pragma once

#include <QFrame>
#include <QLabel>
#include <QProgressBar>

class QPushButton;

namespace hexoderm {

/// A notice of work that takes long: what is being done, how far it is, and a button that gives it up.
class WorkNotice : public QFrame {
  Q_OBJECT

 public:
  explicit WorkNotice(QWidget* parent = nullptr);

  /// `done` of `total` parts; a total below 2: nobody knows how far it is.
  void showWork(const QString& what, int done, int total);
  [[nodiscard]] QString text() const;

 signals:
  void cancelled();

 private:
  QLabel* text_ = new QLabel(this);
  QProgressBar* bar_ = new QProgressBar(this);
  QPushButton* cancel_;
};

}  // namespace hexoderm
