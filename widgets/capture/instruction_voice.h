#pragma once

#include <QObject>
#include <QString>
#include <QTimer>

namespace hexoderm {

class Speaker;

/// Speaks the instruction that stands, for whoever has hands and eyes on the part: when it has changed and stands for a
/// moment, once. What no longer stands is not spoken, nor spoken to its end. Off until it is switched on.
class InstructionVoice : public QObject {
  Q_OBJECT

 public:
  /// An instruction that changes sooner was only passed by.
  static constexpr int kStands_ms = 600;

  /// Takes over the speaker.
  explicit InstructionVoice(Speaker* speaker, QObject* parent = nullptr);

  /// Switched on, it speaks what stands.
  void setEnabled(bool enabled);
  [[nodiscard]] bool isEnabled() const { return enabled_; }
  /// What stands now; empty: nothing. Cheap: may come 20 times a second.
  void setInstruction(const QString& instruction);
  /// Looks for a voice; lookedFor() follows.
  void lookForVoice();

 signals:
  /// `why_not`: empty if there is a voice.
  void lookedFor(const QString& why_not);
  /// A sentence was given to the speaker.
  void spoken(const QString& sentence);

 private:
  void speak();

  Speaker* speaker_;
  QString instruction_;
  QString spoken_;  ///< last, unless something else stood since
  bool enabled_ = false;
  QTimer stands_;
};

}  // namespace hexoderm
