#pragma once

#include <QByteArray>
#include <QObject>

class QThread;

namespace hexoderm {

enum class ToneKind { Captured, StartsOver };

/// Short tones for whoever looks at the part and not at the screen: one for a captured pose, a lower double one for a
/// motion that starts a capture over. Without an audio device none is heard, which is no error; never waits.
class CaptureTone : public QObject {
  Q_OBJECT

 public:
  using QObject::QObject;
  ~CaptureTone() override;

  void setEnabled(bool enabled) { enabled_ = enabled; }
  [[nodiscard]] bool isEnabled() const { return enabled_; }
  /// There is a device to play on; looked up by the first tone.
  [[nodiscard]] bool hasDevice() const;

 public slots:
  void playCaptured() { play(ToneKind::Captured); }
  void playStartsOver() { play(ToneKind::StartsOver); }

 signals:
  /// A tone was asked for while they are enabled, heard or not.
  void played(hexoderm::ToneKind kind);

 private:
  class Player;
  void play(ToneKind kind);

  QThread* thread_ = nullptr;
  Player* player_ = nullptr;
  bool enabled_ = true;
};

/// 16 bit signed mono samples of a tone at a sample rate, little-endian.
QByteArray toneSamples(ToneKind kind, int rate_hz);

}  // namespace hexoderm
