#pragma once

#include "app/window/settings/theme.h"
#include "hexoderm/capture/pose_recorder.h"
#include "hexoderm/solve/result/solver_options.h"

#include <QObject>
#include <QString>

namespace hexoderm {

inline constexpr double kMilliG = 1e-3;  ///< g in a thousandth of it

/// What can be switched on and off.
enum class Switch {
  Tone,
  Speech,  ///< instructions are spoken
  ReducedMotion,
  SoftwareOpenGl,  ///< looked at by prepareSoftwareOpenGl() at the next start
};

/// The operator's choices for all sessions, kept in the settings. Every change is kept and signalled at once; nothing
/// has to be confirmed. A setting that makes no sense (edited by hand, of another version) is replaced by its default.
class Preferences : public QObject {
  Q_OBJECT

 public:
  explicit Preferences(QObject* parent = nullptr);

  /// "system" or one of shippedLanguages(); main() looks it up at the start.
  [[nodiscard]] QString language() const;
  void setLanguage(const QString& language);
  [[nodiscard]] ThemeChoice theme() const;
  void setTheme(ThemeChoice choice);
  /// On top of the system's text size: 0.8 to 2.
  [[nodiscard]] double textFactor() const;
  void setTextFactor(double factor);
  [[nodiscard]] bool isOn(Switch which) const;
  void set(Switch which, bool on);
  /// The folder for new sessions; empty: the folder of the last file.
  [[nodiscard]] QString sessionFolder() const;
  void setSessionFolder(const QString& folder);

  [[nodiscard]] SolverOptions solverOptions() const;
  void setSolverOptions(const SolverOptions& options);
  /// Recorder options with the limits that the dialog shows; the rest is by default.
  [[nodiscard]] PoseRecorderOptions recorderOptions() const;
  void setRecorderOptions(const PoseRecorderOptions& options);

  /// All of the above and the theme; signals follow for what changed.
  void restoreDefaults();

 signals:
  void solverOptionsChanged(const hexoderm::SolverOptions& options);
  void recorderOptionsChanged(const hexoderm::PoseRecorderOptions& options);
  void textFactorChanged(double factor);
  void switched(hexoderm::Switch which, bool on);
  /// The defaults are restored, the theme's too; dialogs show everything again.
  void restored();
};

/// The folder in which dialogs begin to look for a file: that of the last one, as long as it exists; else the user's
/// documents, else the home folder.
QString lastFolder();
/// Notes the folder of a chosen file, for lastFolder(). The folder of unsaved sessions is not noted, as nobody chose
/// it.
void rememberFolder(const QString& file);

/// Gives the application the system's text size times a factor; theme.h's applyTheme() must follow.
void applyTextFactor(double factor);

/// Before there is an application: where the settings or `asked` say so, OpenGL is drawn by the processor (Mesa's
/// software renderer). Needs the organisation's and application's name. True if so.
bool prepareSoftwareOpenGl(bool asked);

}  // namespace hexoderm

Q_DECLARE_METATYPE(hexoderm::SolverOptions)
Q_DECLARE_METATYPE(hexoderm::PoseRecorderOptions)
