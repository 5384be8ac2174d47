#pragma once

#include "app/window/settings/preferences.h"
#include "app/window/settings/theme.h"
#include "app/window/settings/translation.h"
#include "app/window/toolkit/dialogs.h"
#include "hexoderm/base/units.h"
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
#include <QSignalBlocker>
#include <QSpinBox>
#include <QTabBar>
#include <QTabWidget>
#include <QVBoxLayout>
#include <QVariant>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <vector>

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
    auto* tabs = named(new QTabWidget(this), "preferencesTabs", tr("Groups of preferences"));
    tabs->tabBar()->setAccessibleName(tr("Groups of preferences"));
    fillAppearance(addPage(tabs, tr("Appearance")));
    fillCapture(addPage(tabs, tr("Capture")));
    fillSolver(addPage(tabs, tr("Solver")));
    fillFiles(addPage(tabs, tr("Files")));

    auto* note = styledAs(new QLabel(tr("Changes act at once, except where it says otherwise.")), "muted");
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    QPushButton* defaults =
        named(buttons->addButton(tr("Restore defaults"), QDialogButtonBox::ResetRole), "preferencesDefaults");
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
    speech_->setEnabled(why_not.isEmpty() || preferences_.isOn(Switch::Speech));
  }

 signals:
  void themeChosen(hexoderm::ThemeChoice choice);

 private:
  static constexpr std::array<double, 6> kTextFactors = {0.9, 1.0, 1.15, 1.3, 1.5, 2.0};
  /// Sentences over the whole width, under a control or at the end of a page.
  static QLabel* addText(QFormLayout* form, const QString& text, int below = 0) {
    auto* label = styledAs(new QLabel(text), "muted");
    label->setWordWrap(true);
    label->setContentsMargins(0, 0, 0, below);
    form->addRow(label);
    return label;
  }

  static void addRow(QFormLayout* form, const QString& text, QWidget* control, const QString& why) {
    control->setAccessibleName(QString(text).remove(QLatin1Char('&')));
    control->setAccessibleDescription(why);
    form->addRow(labelFor(control, text), control);
    addText(form, why, 8);
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
    connect(theme_, qOverload<int>(&QComboBox::activated), this,
            [this](int index) { emit themeChosen(static_cast<ThemeChoice>(index)); });
    auto* language =
        makeChoice(form, "preferenceLanguage", tr("&Language"), {tr("Like the system")}, tr("From the next start on."));
    language->setItemData(0, QLatin1String(kSystemLanguage));
    for (const QString& shipped : shippedLanguages()) language->addItem(languageName(shipped), shipped);
    bind(
        language, [this, language] { return language->findData(preferences_.language()); },
        [this, language](int index) { preferences_.setLanguage(language->itemData(index).toString()); });
    QStringList sizes;
    for (const double factor : kTextFactors) {
      sizes << (factor == 1.0 ? tr("Like the system") : tr("%1 %").arg(qRound(100 * factor)));
    }
    bind(
        makeChoice(form, "preferenceTextSize", tr("Te&xt size"), sizes,
                   tr("Relative to the text size that the system asks for.")),
        [this] {
          const auto distance = [this](double factor) { return std::abs(factor - preferences_.textFactor()); };
          return static_cast<int>(std::ranges::min_element(kTextFactors, {}, distance) - kTextFactors.begin());
        },
        [this](int index) { preferences_.setTextFactor(kTextFactors.at(static_cast<std::size_t>(index))); });
    makeSwitch(form, "preferenceReducedMotion", Switch::ReducedMotion, tr("&Less motion"),
               tr("Views jump to where they would otherwise glide, and nothing moves by itself."));
    makeSwitch(form, "preferenceSoftwareOpenGl", Switch::SoftwareOpenGl, tr("&Draw without the graphics card"),
               tr("For remote desktops and faulty drivers: OpenGL by the processor, from the next start on. Slower, "
                  "and enough for thousands of cells."));
    addText(form, tr("Lengths are in millimetres and angles in degrees on screen; files hold metres and "
                     "radians."));
  }

  void fillCapture(QFormLayout* form) {
    makeSwitch(form, "preferenceTone", Switch::Tone, tr("&Sound when a pose is captured"),
               tr("So that you know without looking at the screen."));
    speech_ =
        makeSwitch(form, "preferenceSpeech", Switch::Speech, tr("S&peak instructions"),
                   tr("For hands and eyes that are on the robot: what to do next is spoken when it changes, in the "
                      "language of the window."));
    why_no_speech_ = addText(form, {}, 8);
    why_no_speech_->setProperty("muted", false);
    why_no_speech_->setObjectName(QStringLiteral("preferenceWhyNoSpeech"));
    why_no_speech_->hide();
    bindLimit(makeNumber(form, "preferenceExcess", tr("Largest s&catter"), 1, 1000, 1, QStringLiteral("mg"),
                         tr("The part counts as still when its cells scatter by less than this beyond their own noise; "
                            "30 mg is a hand that holds it. A robot's arm allows less.")),
              &StillnessOptions::excess_limit_g, kMilliG);
    bindLimit(makeNumber(form, "preferenceDrift", tr("Largest &turn"), 0.1, 20, 0.1, tr("°/s"),
                         tr("The part counts as still when it turns more slowly than this.")),
              &StillnessOptions::drift_limit_rad_s, kDegree);
    bindLimit(makeNumber(form, "preferenceHold", tr("&Hold for"), 0.2, 1.5, 0.1, QStringLiteral("s"),
                         tr("How long it must be still before samples are taken.")),
              &StillnessOptions::hold_s, 1);
    auto* samples = named(new QSpinBox, "preferenceSamples");
    samples->setRange(0, 5000);
    samples->setSingleStep(50);
    samples->setSpecialValueText(tr("automatic"));
    samples->setKeyboardTracking(false);
    letTypingReplaceSpecialText(samples);
    addRow(
        form, tr("Samples of &each cell"), samples,
        tr("Automatic takes 100, or what slower cells send in 0.75 s. More take longer and make the mean steadier."));
    bind(
        samples, [this] { return static_cast<int>(preferences_.recorderOptions().samples_per_cell); },
        [this](int count) {
          PoseRecorderOptions options = preferences_.recorderOptions();
          options.samples_per_cell = static_cast<std::uint32_t>(count);
          preferences_.setRecorderOptions(options);
        });
    addText(form, tr("Limits act from the next connection on."));
  }

  void fillSolver(QFormLayout* form) {
    const QStringList automatic = {tr("Automatic"), tr("On"), tr("Off")};
    bindSolver(makeChoice(form, "preferenceSolver", tr("&Solver"), {tr("Global"), tr("Tree, as in the paper")},
                          tr("Global uses all links and poses at once and says how sure it is; the tree goes from "
                             "cell to cell along shortest paths.")),
               &SolverOptions::solver);
    bindSolver(makeChoice(form, "preferenceGapModel", tr("&Gap between cells"),
                          {tr("Fit: found from closed loops"), tr("Arc: the mould stretches along an arc"),
                           tr("Pivot: the gap bends in one point")},
                          tr("How the mould gives way between two cells. Fit estimates it from each patch; a patch "
                             "without loops can't tell, and the stated uncertainty says so.")),
               &SolverOptions::gap_model);
    bindSolver(makeChoice(form, "preferenceCentring", tr("Remove sensor &offsets"), automatic,
                          tr("Subtracts each cell's mean over the poses, which takes its sensor's offset away. "
                             "Automatic does so where the poses are good enough for it.")),
               &SolverOptions::centring);
    bindSolver(makeChoice(form, "preferenceSupportAxes", tr("Support &axes"), automatic,
                          tr("Keep links nearly flat in directions that no pose has determined.")),
               &SolverOptions::support_axes);
    bindSolver(
        makeChoice(form, "preferenceWeights", tr("&Weights of the paths"), {tr("Paper: by class"), tr("By residual")},
                   tr("Which links the tree prefers: those of a good class, or those that fit well.")),
        &SolverOptions::weights);
    bind(
        makeNumber(form, "preferenceThreshold", tr("&Threshold of the classes"), 0.05, 3, 0.05, {},
                   tr("A direction counts as defined from this singular value on: 0.5 accepts poses 60° to "
                      "120° apart, 1 is the paper's.")),
        [this] { return preferences_.solverOptions().class_threshold; },
        [this](double threshold) { setSolver(&SolverOptions::class_threshold, threshold); });
  }

  void fillFiles(QFormLayout* form) {
    auto* field = new QWidget;
    auto* row = spaced(new QHBoxLayout(field), {0, 0, 0, 0});
    auto* folder = named(new QLineEdit, "preferenceFolder");
    folder->setPlaceholderText(tr("the folder of the last file"));
    folder->setClearButtonEnabled(true);
    auto* browse = named(new QPushButton(tr("&Browse…")), "preferenceBrowse");
    browse->setAutoDefault(false);
    row->addWidget(folder, 1);
    row->addWidget(browse);
    const QString why = tr("Where new sessions of a connected skin go unless another folder is chosen there.");
    folder->setAccessibleName(tr("Folder for sessions"));
    folder->setAccessibleDescription(why);
    form->addRow(labelFor(folder, tr("&Folder for sessions")), field);
    addText(form, why, 8);
    addText(form, tr("A session that was not saved anywhere is kept beside the program's own data, and offered "
                     "at the next start."));
    show_.emplace_back([this, folder] { folder->setText(QDir::toNativeSeparators(preferences_.sessionFolder())); });
    connect(folder, &QLineEdit::editingFinished, this,
            [this, folder] { preferences_.setSessionFolder(QDir::fromNativeSeparators(folder->text().trimmed())); });
    connect(browse, &QPushButton::clicked, this, [this, folder] {
      askForFile(
          this, "preferenceFolderDialog", tr("Folder for sessions"), folder->text(), {}, this,
          [this, folder](const QString& path) {
            folder->setText(QDir::toNativeSeparators(path));
            preferences_.setSessionFolder(path);
          },
          QFileDialog::Directory);
    });
  }

  QComboBox* makeChoice(QFormLayout* form, const char* name, const QString& label, const QStringList& choices,
                        const QString& why) {
    auto* box = named(new QComboBox, name);
    box->addItems(choices);
    addRow(form, label, box, why);
    return box;
  }

  QDoubleSpinBox* makeNumber(QFormLayout* form, const char* name, const QString& label, double low, double high,
                             double step, const QString& unit, const QString& why) {
    auto* box = named(new QDoubleSpinBox, name);
    box->setRange(low, high);
    box->setSingleStep(step);
    box->setDecimals(step < 0.1 ? 2 : 1);
    if (!unit.isEmpty()) box->setSuffix(QLatin1Char(' ') + unit);
    // Not at every digit: on the way from 3 to 30 nobody wants 3.
    box->setKeyboardTracking(false);
    addRow(form, label, box, why);
    return box;
  }

  QCheckBox* makeSwitch(QFormLayout* form, const char* name, Switch which, const QString& label, const QString& why) {
    auto* box = named(new QCheckBox(label), name);
    box->setAccessibleDescription(why);
    form->addRow(box);
    addText(form, why, 8);
    show_.emplace_back([this, box, which] { box->setChecked(preferences_.isOn(which)); });
    connect(box, &QCheckBox::clicked, this, [this, which](bool on) { preferences_.set(which, on); });
    return box;
  }

  /// The box shows what `get` says, and what the operator makes of it goes to `set`.
  template <class Get, class Set>
  void bind(QComboBox* box, Get get, Set set) {
    show_.emplace_back([box, get] { box->setCurrentIndex(get()); });
    connect(box, qOverload<int>(&QComboBox::activated), this, set);
  }

  template <class SpinBox, class Get, class Set>
  void bind(SpinBox* box, Get get, Set set) {
    show_.emplace_back([box, get] {
      const QSignalBlocker shown_only(box);
      box->setValue(get());
    });
    connect(box, qOverload<decltype(box->value())>(&SpinBox::valueChanged), this, set);
  }

  void bindLimit(QDoubleSpinBox* box, double StillnessOptions::*limit, double unit) {
    bind(
        box, [this, limit, unit] { return preferences_.recorderOptions().stillness.*limit / unit; },
        [this, limit, unit](double value) {
          PoseRecorderOptions options = preferences_.recorderOptions();
          options.stillness.*limit = value * unit;
          preferences_.setRecorderOptions(options);
        });
  }

  /// The choices stand in the order of their enumeration.
  template <class Choice>
  void bindSolver(QComboBox* box, Choice SolverOptions::*choice) {
    bind(
        box, [this, choice] { return static_cast<int>(preferences_.solverOptions().*choice); },
        [this, choice](int index) { setSolver(choice, static_cast<Choice>(index)); });
  }

  template <class Value>
  void setSolver(Value SolverOptions::*option, Value value) {
    SolverOptions options = preferences_.solverOptions();
    options.*option = value;
    preferences_.setSolverOptions(options);
  }

  void showAll() {
    for (const auto& show : show_) show();
  }

  Preferences& preferences_;
  std::vector<std::function<void()>> show_;  ///< in each control what the preferences say
  QComboBox* theme_;
  QCheckBox* speech_;
  QLabel* why_no_speech_;
};

}  // namespace hexoderm
