#pragma once

#include <QByteArray>
#include <QObject>
#include <memory>

namespace hexoderm {

enum class ToneKind { Captured, StartsOver };

/// Short tones for whoever looks at the part and not at the screen: one for a captured pose, a lower double one for a
/// motion that starts a capture over. Without an audio device none is heard, which is no error; never waits.
class CaptureTone : public QObject {
  Q_OBJECT

 public:
  explicit CaptureTone(QObject* parent = nullptr);
  ~CaptureTone() override;

  void setEnabled(bool enabled);
  [[nodiscard]] bool isEnabled() const;
  /// There is a device to play on; looked up by the first tone.
  [[nodiscard]] bool hasDevice() const;

 public slots:
  void playCaptured();
  void playStartsOver();

 signals:
  /// A tone was asked for while they are enabled, heard or not.
  void played(hexoderm::ToneKind kind);

 private:
  void play(ToneKind kind);

  struct Parts;
  std::unique_ptr<Parts> parts_;
};

/// 16 bit signed mono samples of a tone at a sample rate, little-endian.
QByteArray toneSamples(ToneKind kind, int rate_hz);

}  // namespace hexoderm
