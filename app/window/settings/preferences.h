#pragma once

#include "app/window/files/session_paths.h"
#include "app/window/settings/theme.h"
#include "app/window/settings/translation.h"
#include "hexoderm/base/error.h"
#include "hexoderm/base/units.h"
#include "hexoderm/capture/pose_recorder.h"
#include "hexoderm/solve/result/solver_options.h"

#include <QApplication>
#include <QDir>
#include <QFileInfo>
#include <QFont>
#include <QObject>
#include <QSettings>
#include <QStandardPaths>
#include <QString>
#include <algorithm>
#include <array>
#include <cmath>

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
  explicit Preferences(QObject* parent = nullptr) : QObject(parent) {}

  /// "system" or one of shippedLanguages(); main() looks it up at the start.
  [[nodiscard]] QString language() const {
    const QString language = QSettings().value(kLanguage).toString();
    return isLanguageChoice(language) ? language : QLatin1String(kSystemLanguage);
  }
  void setLanguage(const QString& language) { QSettings().setValue(kLanguage, language); }
  [[nodiscard]] ThemeChoice theme() const {
    return themeChoiceFromName(QSettings().value(kTheme).toString()).value_or(ThemeChoice::System);
  }
  void setTheme(ThemeChoice choice) { QSettings().setValue(kTheme, themeChoiceName(choice)); }
  /// On top of the system's text size: 0.8 to 2.
  [[nodiscard]] double textFactor() const {
    double factor = 1;
    readNumber(kTextFactor, factor);
    return std::clamp(factor, 0.8, 2.0);
  }
  void setTextFactor(double factor) {
    if (factor == textFactor()) return;
    QSettings().setValue(kTextFactor, factor);
    emit textFactorChanged(textFactor());
  }
  [[nodiscard]] bool isOn(Switch which) const {
    const SwitchRow& row = kSwitches.at(static_cast<std::size_t>(which));
    return QSettings().value(QLatin1String(row.key), row.is_on_at_first).toBool();
  }
  void set(Switch which, bool on) {
    if (on == isOn(which)) return;
    QSettings().setValue(QLatin1String(kSwitches.at(static_cast<std::size_t>(which)).key), on);
    emit switched(which, on);
  }
  /// The folder for new sessions; empty: the folder of the last file.
  [[nodiscard]] QString sessionFolder() const { return QSettings().value(kFolder).toString(); }
  void setSessionFolder(const QString& folder) { QSettings().setValue(kFolder, folder); }

  [[nodiscard]] SolverOptions solverOptions() const {
    SolverOptions options;
    for (const SolverChoice& choice : solverChoices()) {
      const QString value = QSettings().value(keyOf(choice)).toString();
      if (value.isEmpty()) continue;
      try {
        choice.set(options, value.toStdString());
      } catch (const InvalidArgument&) {
        continue;  // it is no name: the default stays
      }
    }
    readNumber(kThreshold, options.class_threshold);
    try {
      options.validate();
    } catch (const InvalidArgument&) {
      return {};
    }
    return options;
  }
  void setSolverOptions(const SolverOptions& options) {
    if (options == solverOptions()) return;
    for (const SolverChoice& choice : solverChoices()) {
      const std::string_view value = choice.get(options);
      QSettings().setValue(keyOf(choice), QString::fromUtf8(value.data(), static_cast<int>(value.size())));
    }
    QSettings().setValue(kThreshold, options.class_threshold);
    emit solverOptionsChanged(solverOptions());
  }
  /// Recorder options with the limits that the dialog shows; the rest is by default.
  [[nodiscard]] PoseRecorderOptions recorderOptions() const {
    PoseRecorderOptions options;
    for (const LimitRow& row : kLimits) readNumber(QLatin1String(row.key), options.stillness.*row.limit, row.unit);
    options.samples_per_cell = QSettings().value(kSamples, options.samples_per_cell).toUInt();
    options.stillness.drift_window_s = std::max(options.stillness.drift_window_s, options.stillness.hold_s);
    try {
      options.validate();
    } catch (const InvalidArgument&) {
      return {};
    }
    return options;
  }
  void setRecorderOptions(const PoseRecorderOptions& options) {
    const PoseRecorderOptions before = recorderOptions();
    QSettings settings;
    for (const LimitRow& row : kLimits) {
      // Rounded, so that what was typed is what is kept.
      settings.setValue(QLatin1String(row.key), std::round(options.stillness.*row.limit / row.unit * 1e6) / 1e6);
    }
    settings.setValue(kSamples, options.samples_per_cell);
    const PoseRecorderOptions now = recorderOptions();
    const bool is_limit_changed = std::ranges::any_of(
        kLimits, [&](const LimitRow& row) { return now.stillness.*row.limit != before.stillness.*row.limit; });
    if (is_limit_changed || now.samples_per_cell != before.samples_per_cell) emit recorderOptionsChanged(now);
  }

  /// All of the above and the theme; signals follow for what changed.
  void restoreDefaults() {
    for (std::size_t k = 0; k < kSwitches.size(); ++k) set(static_cast<Switch>(k), kSwitches.at(k).is_on_at_first);
    QSettings settings;
    for (const QString& key : {kLanguage, kTheme, kFolder}) settings.remove(key);
    for (const SwitchRow& row : kSwitches) settings.remove(QLatin1String(row.key));
    setTextFactor(1);
    setSolverOptions({});
    setRecorderOptions({});
    emit restored();
  }

 signals:
  void solverOptionsChanged(const hexoderm::SolverOptions& options);
  void recorderOptionsChanged(const hexoderm::PoseRecorderOptions& options);
  void textFactorChanged(double factor);
  void switched(hexoderm::Switch which, bool on);
  /// The defaults are restored, the theme's too; dialogs show everything again.
  void restored();

 private:
  static inline const QString kLanguage = QStringLiteral("view/language");
  static inline const QString kTextFactor = QStringLiteral("view/text_factor");
  static inline const QString kTheme = QStringLiteral("view/theme");
  static inline const QString kSamples = QStringLiteral("capture/samples_per_cell");
  static inline const QString kFolder = QStringLiteral("paths/sessions");
  static inline const QString kThreshold = QStringLiteral("solver/class_threshold");

  struct SwitchRow {
    const char* key;
    bool is_on_at_first;
  };
  /// In the order of Switch.
  static constexpr std::array<SwitchRow, 4> kSwitches = {{{"capture/tone", true},
                                                          {"capture/speech", false},
                                                          {"view/reduced_motion", false},
                                                          {"view/software_opengl", false}}};

  /// A limit of the recorder, which is kept in a unit of its own.
  struct LimitRow {
    const char* key;
    double StillnessOptions::*limit;
    double unit;
  };
  static constexpr LimitRow kLimits[] = {{"capture/drift_limit_deg_s", &StillnessOptions::drift_limit_rad_s, kDegree},
                                         {"capture/excess_limit_mg", &StillnessOptions::excess_limit_g, kMilliG},
                                         {"capture/hold_s", &StillnessOptions::hold_s, 1}};

  /// "solver/gap_model" of gap-model.
  static QString keyOf(const SolverChoice& choice) {
    const QString name = QString::fromUtf8(choice.name.data(), static_cast<int>(choice.name.size()));
    return QStringLiteral("solver/") + QString(name).replace(QLatin1Char('-'), QLatin1Char('_'));
  }

  static void readNumber(const QString& key, double& value, double unit = 1) {
    bool is_number = false;
    const double read = QSettings().value(key).toDouble(&is_number);
    if (is_number && std::isfinite(read)) value = read * unit;
  }
};

/// The folder in which dialogs begin to look for a file: that of the last one, as long as it exists; else the user's
/// documents, else the home folder.
inline QString lastFolder() {
  const QString folder = QSettings().value(QStringLiteral("paths/last")).toString();
  if (!folder.isEmpty() && QDir(folder).exists()) return folder;
  const QString documents = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
  return QDir(documents).exists() ? documents : QDir::homePath();
}
/// Notes the folder of a chosen file, for lastFolder(). The folder of unsaved sessions is not noted, as nobody chose
/// it.
inline void rememberFolder(const QString& file) {
  if (file.isEmpty() || isInUnsavedFolder(file)) return;
  QSettings().setValue(QStringLiteral("paths/last"), QFileInfo(file).absolutePath());
}

/// Gives the application the system's text size times a factor; theme.h's applyTheme() must follow.
inline void applyTextFactor(double factor) {
  // The system's, as it was before the first factor.
  static const QFont kSystem = QApplication::font();
  QFont font = kSystem;
  if (font.pointSizeF() > 0) {
    font.setPointSizeF(std::round(font.pointSizeF() * factor * 10) / 10);
  } else {
    font.setPixelSize(static_cast<int>(std::lround(font.pixelSize() * factor)));
  }
  // Without ligatures, which take long to look for. Scripts that need shaping are still shaped.
  font.setStyleStrategy(QFont::PreferNoShaping);
  QApplication::setFont(font);
}

/// Before there is an application: where the settings or `asked` say so, OpenGL is drawn by the processor (Mesa's
/// software renderer). Needs the organisation's and application's name. True if so.
inline bool prepareSoftwareOpenGl(bool asked) {
  if (!asked && !Preferences().isOn(Switch::SoftwareOpenGl)) return false;
  qputenv("LIBGL_ALWAYS_SOFTWARE", "1");
  // It would send all drawing to the display's server, which knows no OpenGL that is new enough.
  qunsetenv("LIBGL_ALWAYS_INDIRECT");
  qputenv("QT_OPENGL", "software");
  QCoreApplication::setAttribute(Qt::AA_UseSoftwareOpenGL);
  return true;
}

}  // namespace hexoderm

Q_DECLARE_METATYPE(hexoderm::SolverOptions)
Q_DECLARE_METATYPE(hexoderm::PoseRecorderOptions)
