#pragma once

#include "app/window/settings/theme.h"

#include <QDialog>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QLabel;
class QLineEdit;
class QSpinBox;
class QTabWidget;

namespace hexoderm {

class Preferences;

/// Shows and changes the preferences. Every change acts at once, so that there is nothing to confirm; stands beside the
/// window, which goes on.
class PreferencesDialog : public QDialog {
  Q_OBJECT

 public:
  /// `preferences` must outlive the dialog. `theme`: the choice that is in force.
  PreferencesDialog(Preferences& preferences, ThemeChoice theme, QWidget* parent = nullptr);

  /// It was changed elsewhere.
  void showTheme(ThemeChoice theme);
  /// Whether instructions can be spoken; a reason: why they can't.
  void setWhyNoSpeech(const QString& why_not);

 signals:
  void themeChosen(hexoderm::ThemeChoice choice);

 private:
  void fillAppearance(QFormLayout* form);
  void fillCapture(QFormLayout* form);
  void fillSolver(QFormLayout* form);
  void fillFiles(QFormLayout* form);
  QComboBox* makeChoice(QFormLayout* form, const char* name, const QString& label, const QStringList& choices,
                        const QString& why);
  QDoubleSpinBox* makeNumber(QFormLayout* form, const char* name, const QString& label, double low, double high,
                             double step, const QString& unit, const QString& why);
  QCheckBox* makeSwitch(QFormLayout* form, const char* name, const QString& label, const QString& why);
  void showAll();
  void takeSolver();
  void takeRecorder();
  void chooseFolder();

  Preferences& preferences_;
  bool showing_ = false;  ///< controls are being set, not changed by the operator

  QComboBox* theme_;
  QComboBox* language_;
  QComboBox* text_size_;
  QCheckBox* reduced_motion_;
  QCheckBox* software_opengl_;
  QCheckBox* tone_;
  QCheckBox* speech_;
  QLabel* why_no_speech_;
  QDoubleSpinBox* drift_;
  QDoubleSpinBox* excess_;
  QDoubleSpinBox* hold_;
  QSpinBox* samples_;
  QComboBox* solver_;
  QComboBox* gap_model_;
  QComboBox* centring_;
  QComboBox* support_axes_;
  QComboBox* weights_;
  QDoubleSpinBox* threshold_;
  QLineEdit* folder_;
};

}  // namespace hexoderm
