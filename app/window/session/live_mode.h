#pragma once

#include "hexoderm/solve/reconstruction_worker.h"

#include <QObject>
#include <memory>

namespace hexoderm {

class SessionController;

/// The skin as its readings of this moment alone show it, instead of the session's result.
class LiveMode : public QObject {
  Q_OBJECT

 public:
  /// `controller` outlives this object.
  explicit LiveMode(SessionController& controller);

  [[nodiscard]] bool isOn() const { return is_on_; }

  // For the other parts of the session.

  /// Solves the newest readings.
  void solve();
  /// Gives up what waits to be solved.
  void cancel() { worker_.cancel(); }

 public slots:
  /// Stays off where no skin is connected.
  void setOn(bool on);

 signals:
  /// After it ends, the result that was not shown meanwhile is still the same.
  void toggled(bool on);
  /// Every moment that was solved.
  void momentSolved(std::shared_ptr<const hexoderm::Reconstruction> reconstruction);

 private:
  void receive(const ReconstructionOutcome& outcome);

  SessionController& controller_;
  bool is_on_ = false;
  bool fails_ = false;           ///< told once
  ReconstructionWorker worker_;  // last: its thread has ended before what it reports to goes
};

}  // namespace hexoderm
