#pragma once

#include "app/window/settings/preferences.h"
#include "app/window/settings/theme.h"
#include "app/window/settings/translation.h"
#include "app/window/toolkit/file_dialog.h"
#include "hexoderm/util/units.h"
#include "widgets/controls/panel_parts.h"
#include "widgets/controls/typed_values.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialog>
#include <QDialogButtonBox>
#include <QDir>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScreen>
#include <QScrollArea>
#include <QSpinBox>
#include <QTabBar>
#include <QTabWidget>
#include <QVBoxLayout>
#include <QVariant>
#include <array>
#include <cmath>

namespace hexoderm {

/// Shows and changes the preferences. Every change acts at once, so that there is nothing to confirm; stands beside the
/// window, which goes on.
class PreferencesDialog : public QDialog {
  Q_OBJECT

 public:
  /// `preferences` must outlive the dialog. `theme`: the choice that is in force.
  PreferencesDialog(Preferences& preferences, ThemeChoice theme, QWidget* parent = nullptr)
      : QDialog(parent), preferences_(preferences) {
    setObjectName(QStringLiteral("preferencesDialog"));
    setWindowTitle(tr("Preferences"));
    auto* tabs = new QTabWidget(this);
    setNames(tabs, QStringLiteral("preferencesTabs"), tr("Groups of preferences"));
    tabs->tabBar()->setAccessibleName(tr("Groups of preferences"));
    fillAppearance(addPage(tabs, tr("Appearance")));
    fillCapture(addPage(tabs, tr("Capture")));
    fillSolver(addPage(tabs, tr("Solver")));
    fillFiles(addPage(tabs, tr("Files")));

    auto* note = new QLabel(tr("Changes act at once, except where it says otherwise."));
    note->setProperty("muted", true);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    QPushButton* defaults = buttons->addButton(tr("Restore defaults"), QDialogButtonBox::ResetRole);
    defaults->setObjectName(QStringLiteral("preferencesDefaults"));
    defaults->setToolTip(tr("All preferences on all pages become as they were at the first start"));
    defaults->setAutoDefault(false);
    connect(defaults, &QPushButton::clicked, this, [this] {
      preferences_.restoreDefaults();
      emit themeChosen(ThemeChoice::System);
    });
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* layout = spaced(new QVBoxLayout(this), {10, 10, 10, 12});
    layout->addWidget(tabs, 1);
    addWidgets(layout, {note, buttons});
    connect(&preferences_, &Preferences::restored, this, &PreferencesDialog::showAll);
    showAll();
    showTheme(theme);
    const int width = 62 * fontMetrics().averageCharWidth() + 60;
    const int height = 34 * fontMetrics().height();
    resize(QSize(width, height).boundedTo(0.9 * (parent ? parent->screen() : screen())->availableSize()));
  }

  /// It was changed elsewhere.
  void showTheme(ThemeChoice theme) { theme_->setCurrentIndex(static_cast<int>(theme)); }
  /// Whether instructions can be spoken; a reason: why they can't.
  void setWhyNoSpeech(const QString& why_not) {
    why_no_speech_->setText(why_not.isEmpty() ? QString() : tr("Not available: %1").arg(why_not));
    why_no_speech_->setVisible(!why_not.isEmpty());
    // What is switched on can be switched off, whatever became of the voice.
    speech_->setEnabled(why_not.isEmpty() || preferences_.speech());
  }

 signals:
  void themeChosen(hexoderm::ThemeChoice choice);

 private:
  static constexpr std::array<double, 6> kTextFactors = {0.9, 1.0, 1.15, 1.3, 1.5, 2.0};
  /// One sentence under a control.
  static void addWhy(QFormLayout* form, const QString& why) {
    auto* label = new QLabel(why);
    label->setWordWrap(true);
    label->setProperty("muted", true);
    label->setContentsMargins(0, 0, 0, 8);
    form->addRow(label);
  }

  static void addRow(QFormLayout* form, const QString& text, QWidget* control, const QString& why) {
    control->setAccessibleName(QString(text).remove(QLatin1Char('&')));
    control->setAccessibleDescription(why);
    form->addRow(labelFor(control, text), control);
    addWhy(form, why);
  }

  /// A page scrolls where the screen is smaller than it. It has its place in the dialog before anything is put into it:
  /// a widget that gets another parent is styled again by the style sheet, with all its contents.
  static QFormLayout* addPage(QTabWidget* tabs, const QString& title) {
    auto* area = new QScrollArea;
    tabs->addTab(area, title);
    scrollPlainly(area);
    auto* content = new QWidget;
    area->setWidget(content);
    auto* form = spaced(new QFormLayout(content), {18, 16, 18, 16});
    form->setHorizontalSpacing(18);
    form->setVerticalSpacing(6);
    form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    // With large text a label and its control don't fit side by side.
    form->setRowWrapPolicy(QFormLayout::WrapLongRows);
    return form;
  }

  void fillAppearance(QFormLayout* form) {
    theme_ = makeChoice(form, "preferenceTheme", tr("&Theme"), {tr("Like the system"), tr("Light"), tr("Dark")},
                        tr("Light or dark, or what the system asks for."));
    language_ =
        makeChoice(form, "preferenceLanguage", tr("&Language"), {tr("Like the system")}, tr("From the next start on."));
    language_->setItemData(0, QLatin1String(kSystemLanguage));
    for (const QString& language : shippedLanguages()) {
      language_->addItem(languageName(language), language);
    }
    QStringList sizes;
    for (const double factor : kTextFactors) {
      sizes << (factor == 1.0 ? tr("Like the system") : tr("%1 %").arg(qRound(100 * factor)));
    }
    text_size_ = makeChoice(form, "preferenceTextSize", tr("Te&xt size"), sizes,
                            tr("Relative to the text size that the system asks for."));
    reduced_motion_ = makeSwitch(form, "preferenceReducedMotion", tr("&Less motion"),
                                 tr("Views jump to where they would otherwise glide, and nothing moves by itself."));
    software_opengl_ = makeSwitch(
        form, "preferenceSoftwareOpenGl", tr("&Draw without the graphics card"),
        tr("For remote desktops and faulty drivers: OpenGL by the processor, from the next start on. Slower, "
           "and enough for thousands of cells."));
    auto* units =
        new QLabel(tr("Lengths are in millimetres and angles in degrees on screen; files hold metres and "
                      "radians."));
    units->setWordWrap(true);
    units->setProperty("muted", true);
    form->addRow(units);

    connect(theme_, qOverload<int>(&QComboBox::activated), this,
            [this](int index) { emit themeChosen(static_cast<ThemeChoice>(index)); });
    connect(language_, qOverload<int>(&QComboBox::activated), this,
            [this](int index) { preferences_.setLanguage(language_->itemData(index).toString()); });
    connect(text_size_, qOverload<int>(&QComboBox::activated), this,
            [this](int index) { preferences_.setTextFactor(kTextFactors.at(static_cast<std::size_t>(index))); });
    connect(reduced_motion_, &QCheckBox::clicked, this, [this](bool on) { preferences_.setReducedMotion(on); });
    connect(software_opengl_, &QCheckBox::clicked, this, [this](bool on) { preferences_.setSoftwareOpenGl(on); });
  }

  void fillCapture(QFormLayout* form) {
    tone_ = makeSwitch(form, "preferenceTone", tr("&Sound when a pose is captured"),
                       tr("So that you know without looking at the screen."));
    speech_ =
        makeSwitch(form, "preferenceSpeech", tr("S&peak instructions"),
                   tr("For hands and eyes that are on the robot: what to do next is spoken when it changes, in the "
                      "language of the window."));
    why_no_speech_ = new QLabel;
    why_no_speech_->setObjectName(QStringLiteral("preferenceWhyNoSpeech"));
    why_no_speech_->setWordWrap(true);
    why_no_speech_->setContentsMargins(0, 0, 0, 8);
    why_no_speech_->hide();
    form->addRow(why_no_speech_);
    excess_ = makeNumber(form, "preferenceExcess", tr("Largest s&catter"), 1, 1000, 1, QStringLiteral("mg"),
                         tr("The part counts as still when its cells scatter by less than this beyond their own noise; "
                            "30 mg is a hand that holds it. A robot's arm allows less."));
    drift_ = makeNumber(form, "preferenceDrift", tr("Largest &turn"), 0.1, 20, 0.1, tr("°/s"),
                        tr("The part counts as still when it turns more slowly than this."));
    hold_ = makeNumber(form, "preferenceHold", tr("&Hold for"), 0.2, 1.5, 0.1, QStringLiteral("s"),
                       tr("How long it must be still before samples are taken."));
    samples_ = new QSpinBox;
    samples_->setObjectName(QStringLiteral("preferenceSamples"));
    samples_->setRange(0, 5000);
    samples_->setSingleStep(50);
    samples_->setSpecialValueText(tr("automatic"));
    samples_->setKeyboardTracking(false);
    letTypingReplaceSpecialText(samples_);
    addRow(
        form, tr("Samples of &each cell"), samples_,
        tr("Automatic takes 100, or what slower cells send in 0.75 s. More take longer and make the mean steadier."));
    auto* when = new QLabel(tr("Limits act from the next connection on."));
    when->setWordWrap(true);
    when->setProperty("muted", true);
    form->addRow(when);

    connect(tone_, &QCheckBox::clicked, this, [this](bool on) { preferences_.setTone(on); });
    connect(speech_, &QCheckBox::clicked, this, [this](bool on) { preferences_.setSpeech(on); });
    for (QDoubleSpinBox* box : {drift_, excess_, hold_}) {
      connect(box, qOverload<double>(&QDoubleSpinBox::valueChanged), this, &PreferencesDialog::takeRecorder);
    }
    connect(samples_, qOverload<int>(&QSpinBox::valueChanged), this, &PreferencesDialog::takeRecorder);
  }

  void fillSolver(QFormLayout* form) {
    const QStringList automatic = {tr("Automatic"), tr("On"), tr("Off")};
    solver_ =
        makeChoice(form, "preferenceSolver", tr("&Solver"), {tr("Global"), tr("Tree, as in the paper")},
                   tr("Global uses all links and poses at once and says how sure it is; the tree goes from cell to "
                      "cell along shortest paths."));
    gap_model_ = makeChoice(form, "preferenceGapModel", tr("&Gap between cells"),
                            {tr("Fit: found from closed loops"), tr("Arc: the mould stretches along an arc"),
                             tr("Pivot: the gap bends in one point")},
                            tr("How the mould gives way between two cells. Fit estimates it from each patch; a patch "
                               "without loops can't tell, and the stated uncertainty says so."));
    centring_ =
        makeChoice(form, "preferenceCentring", tr("Remove sensor &offsets"), automatic,
                   tr("Subtracts each cell's mean over the poses, which takes its sensor's offset away. Automatic "
                      "does so where the poses are good enough for it."));
    support_axes_ = makeChoice(form, "preferenceSupportAxes", tr("Support &axes"), automatic,
                               tr("Keep links nearly flat in directions that no pose has determined."));
    weights_ =
        makeChoice(form, "preferenceWeights", tr("&Weights of the paths"), {tr("Paper: by class"), tr("By residual")},
                   tr("Which links the tree prefers: those of a good class, or those that fit well."));
    threshold_ = makeNumber(form, "preferenceThreshold", tr("&Threshold of the classes"), 0.05, 3, 0.05, {},
                            tr("A direction counts as defined from this singular value on: 0.5 accepts poses 60° to "
                               "120° apart, 1 is the paper's."));
    for (QComboBox* box : {solver_, gap_model_, centring_, support_axes_, weights_}) {
      connect(box, qOverload<int>(&QComboBox::activated), this, &PreferencesDialog::takeSolver);
    }
    connect(threshold_, qOverload<double>(&QDoubleSpinBox::valueChanged), this, &PreferencesDialog::takeSolver);
  }

  void fillFiles(QFormLayout* form) {
    auto* field = new QWidget;
    auto* row = spaced(new QHBoxLayout(field), {0, 0, 0, 0});
    folder_ = new QLineEdit;
    folder_->setObjectName(QStringLiteral("preferenceFolder"));
    folder_->setPlaceholderText(tr("the folder of the last file"));
    folder_->setClearButtonEnabled(true);
    auto* browse = new QPushButton(tr("&Browse…"));
    browse->setObjectName(QStringLiteral("preferenceBrowse"));
    browse->setAutoDefault(false);
    row->addWidget(folder_, 1);
    row->addWidget(browse);
    const QString why = tr("Where new sessions of a connected skin go unless another folder is chosen there.");
    folder_->setAccessibleName(tr("Folder for sessions"));
    folder_->setAccessibleDescription(why);
    form->addRow(labelFor(folder_, tr("&Folder for sessions")), field);
    addWhy(form, why);
    auto* kept =
        new QLabel(tr("A session that was not saved anywhere is kept beside the program's own data, and offered "
                      "at the next start."));
    kept->setWordWrap(true);
    kept->setProperty("muted", true);
    form->addRow(kept);
    connect(browse, &QPushButton::clicked, this, &PreferencesDialog::chooseFolder);
    connect(folder_, &QLineEdit::editingFinished, this,
            [this] { preferences_.setSessionFolder(QDir::fromNativeSeparators(folder_->text().trimmed())); });
  }

  QComboBox* makeChoice(QFormLayout* form, const char* name, const QString& label, const QStringList& choices,
                        const QString& why) {
    auto* box = new QComboBox;
    box->setObjectName(QLatin1String(name));
    box->addItems(choices);
    addRow(form, label, box, why);
    return box;
  }

  QDoubleSpinBox* makeNumber(QFormLayout* form, const char* name, const QString& label, double low, double high,
                             double step, const QString& unit, const QString& why) {
    auto* box = new QDoubleSpinBox;
    box->setObjectName(QLatin1String(name));
    box->setRange(low, high);
    box->setSingleStep(step);
    box->setDecimals(step < 0.1 ? 2 : 1);
    if (!unit.isEmpty()) box->setSuffix(QLatin1Char(' ') + unit);
    // Not at every digit: on the way from 3 to 30 nobody wants 3.
    box->setKeyboardTracking(false);
    addRow(form, label, box, why);
    return box;
  }

  QCheckBox* makeSwitch(QFormLayout* form, const char* name, const QString& label, const QString& why) {
    auto* box = new QCheckBox(label);
    box->setObjectName(QLatin1String(name));
    box->setAccessibleDescription(why);
    form->addRow(box);
    addWhy(form, why);
    return box;
  }

  void showAll() {
    showing_ = true;
    language_->setCurrentIndex(language_->findData(preferences_.language()));
    std::size_t nearest = 0;
    for (std::size_t k = 0; k < kTextFactors.size(); ++k) {
      const double factor = preferences_.textFactor();
      if (std::abs(kTextFactors.at(k) - factor) < std::abs(kTextFactors.at(nearest) - factor)) nearest = k;
    }
    text_size_->setCurrentIndex(static_cast<int>(nearest));
    reduced_motion_->setChecked(preferences_.reducedMotion());
    software_opengl_->setChecked(preferences_.softwareOpenGl());
    tone_->setChecked(preferences_.tone());
    speech_->setChecked(preferences_.speech());
    const PoseRecorderOptions recorder = preferences_.recorderOptions();
    drift_->setValue(toDegrees(recorder.stillness.drift_limit_rad_s));
    excess_->setValue(recorder.stillness.excess_limit_g / kMilliG);
    hold_->setValue(recorder.stillness.hold_s);
    samples_->setValue(static_cast<int>(recorder.samples_per_cell));
    const SolverOptions solver = preferences_.solverOptions();
    solver_->setCurrentIndex(static_cast<int>(solver.solver));
    gap_model_->setCurrentIndex(static_cast<int>(solver.gap_model));
    centring_->setCurrentIndex(static_cast<int>(solver.centring));
    support_axes_->setCurrentIndex(static_cast<int>(solver.support_axes));
    weights_->setCurrentIndex(static_cast<int>(solver.weights));
    threshold_->setValue(solver.class_threshold);
    folder_->setText(QDir::toNativeSeparators(preferences_.sessionFolder()));
    showing_ = false;
  }

  void takeSolver() {
    if (showing_) return;
    SolverOptions options = preferences_.solverOptions();
    options.solver = static_cast<Solver>(solver_->currentIndex());
    options.gap_model = static_cast<GapModel>(gap_model_->currentIndex());
    options.centring = static_cast<Centring>(centring_->currentIndex());
    options.support_axes = static_cast<SupportAxes>(support_axes_->currentIndex());
    options.weights = static_cast<LinkWeights>(weights_->currentIndex());
    options.class_threshold = threshold_->value();
    preferences_.setSolverOptions(options);
  }

  void takeRecorder() {
    if (showing_) return;
    PoseRecorderOptions options = preferences_.recorderOptions();
    options.stillness.drift_limit_rad_s = drift_->value() * kDegree;
    options.stillness.excess_limit_g = excess_->value() * kMilliG;
    options.stillness.hold_s = hold_->value();
    options.samples_per_cell = static_cast<std::uint32_t>(samples_->value());
    preferences_.setRecorderOptions(options);
  }

  void chooseFolder() {
    askForFolder(this, "preferenceFolderDialog", tr("Folder for sessions"), folder_->text(), this,
                 [this](const QString& path) {
                   folder_->setText(QDir::toNativeSeparators(path));
                   preferences_.setSessionFolder(path);
                 });
  }

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
