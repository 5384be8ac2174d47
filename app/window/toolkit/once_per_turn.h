#pragma once

#include <QObject>
#include <functional>

namespace hexoderm {

/// Does a piece of work in the next turn of the event loop, once, however often it was requested before that.
class OncePerTurn : public QObject {
  Q_OBJECT

 public:
  explicit OncePerTurn(std::function<void()> work, QObject* parent = nullptr);

  /// Does the work at once if it was requested, for pictures that can't wait for the next turn.
  void finish();

 public slots:
  void request();

 signals:
  /// The work was done.
  void done();

 private:
  std::function<void()> work_;
  bool requested_ = false;
};

}  // namespace hexoderm
