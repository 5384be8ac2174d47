#pragma once

#include "hexoderm/base/error.h"
#include "hexoderm/base/units.h"
#include "widgets/controls/column_layout.h"
#include "widgets/controls/panel_parts.h"
#include "widgets/controls/typed_values.h"
#include "widgets/verify/verify_section.h"
#include "widgets/words/surface_words.h"
#include "widgets/words/words.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QStringList>
#include <QToolButton>
#include <QWidget>
#include <algorithm>
#include <array>
#include <initializer_list>
#include <limits>
#include <memory>
#include <optional>
#include <utility>

namespace hexoderm {

enum class VerifyCheck { HoldOut, Loops, Surface, Comparison, OldCalibration };

/// The checks of a finished calibration, each with a verdict: do the other poses predict one that is left out, do its
/// loops close, do its cells lie on the surface they were put on, does a distance measured by hand agree, does it
/// repeat? And of an old calibration: does it still hold, by the poses of today? The panel asks by its requests and
/// shows the results that it is given, in as many columns as there is room for.
class VerifyPanel : public QWidget {
  Q_OBJECT

 public:
  /// `selection` must outlive the panel.
  explicit VerifyPanel(Selection* selection, QWidget* parent = nullptr) : QWidget(parent), selection_(selection) {
    setObjectName(QStringLiteral("verifyPanel"));
    buildHoldOut();
    buildSurface();
    buildCaliper();
    buildComparison();
    buildOldCalibration();
    constexpr int kColumnCharacters = 44;
    auto* layout = new ColumnLayout(kColumnCharacters * fontMetrics().averageCharWidth(), this);
    layout->setContentsMargins(14, 12, 14, 12);
    layout->setSpacing(18);
    for (VerifySection* section : sections()) layout->addWidget(section);

    for (const VerifyCheck check : kChecks) {
      connect(sectionOf(check), &VerifySection::cancelled, this, [this, check] { emit cancelRequested(check); });
    }
    // What it said was about other poses.
    connect(old_, &VerifySection::cancelled, this, [this] {
      old_->setMetrics({});
      old_->setSentence({Tone::Neutral, tr("Cancelled.")});
    });
    connect(loop_, &VerifySection::rowPicked, this, [this](int row) {
      emit loopShown(row < 0 ? std::nullopt : std::optional(loops_.at(static_cast<std::size_t>(row)).closure));
    });
    // The surface that the row belongs to: the table lists one after the other.
    connect(surface_, &VerifySection::rowPicked, this, [this](int row) {
      for (const SurfaceEvaluation& surface : surfaces_) {
        const auto count = static_cast<int>(surface.cells.size());
        if (row >= 0 && row < count) emit surfaceShown(surface);
        row -= count;
      }
    });
    setReconstruction(nullptr);
  }

  /// Sets the calibration to verify; results about an earlier state of it go.
  void setReconstruction(std::shared_ptr<const Reconstruction> reconstruction) {
    const bool changed = reconstruction != reconstruction_;
    reconstruction_ = std::move(reconstruction);
    if (changed && hold_out_result_) {
      hold_out_result_.reset();
      hold_out_outdated_ = true;
      showHoldOutMetrics();
    }
    if (!reconstruction_) hold_out_outdated_ = false;
    const QVariant chosen = pose_->currentData();
    pose_->clear();
    if (reconstruction_) {
      for (const PoseSummary& pose : reconstruction_->poses) {
        QString text = tr("Pose %1").arg(pose.pose.value());
        if (!pose.label.empty()) text += QStringLiteral(" · ") + words(pose.label);
        if (!pose.enabled) text += QStringLiteral(" · ") + tr("disabled");
        pose_->addItem(text, pose.pose.value());
      }
    }
    const int place = pose_->findData(chosen);
    pose_->setCurrentIndex(place >= 0 ? place : pose_->count() - 1);
    if (!reconstruction_) {
      for (VerifySection* section : sections()) section->clear();
      for (const VerifyCheck check : kChecks) forget(check);
    }
    proposeCells();
    checkCaliper();
    refreshControls();
  }

  /// Whether there is a session that a pose can be held out of, as there is none for a calibration; there is at first.
  void setHasReadings(bool has_readings) {
    has_readings_ = has_readings;
    refreshControls();
  }

  /// What is going on while there is no skin, in words; empty: nothing is.
  void setAwaited(const QString& awaited) {
    awaited_ = awaited;
    refreshControls();
  }

  void setRunning(VerifyCheck check, bool running) {
    sectionOf(check)->setRunning(running);
    refreshControls();
  }

  void showHoldOut(const HoldOutResult& result) {
    hold_out_result_ = result;
    hold_out_outdated_ = false;
    hold_out_->setSentence(holdOutText(result));
    showHoldOutMetrics();
  }

  void showLoops(const std::vector<FoundLoop>& loops) {
    loops_ = loops;
    loop_->setSentence(loopsText(loops, reconstruction_ ? reconstruction_->patches.size() : 0));
    loop_->setMetrics(loopMetrics(loops));
    // Open loops are looked at first; nothing is drawn of a sheet with hundreds of closed ones until one is picked.
    const bool open = !loops.empty() && !loops.front().closed;
    emit loopShown(open ? std::optional(loops.front().closure) : std::nullopt);
  }

  /// One a patch; `remarks` say why there is none of another.
  void showSurfaces(const std::vector<SurfaceEvaluation>& surfaces, const QStringList& remarks) {
    surfaces_ = surfaces;
    const std::optional<double> stated = reconstruction_ ? reconstruction_->assessment.position_95_m : std::nullopt;
    VerifySentence all;
    QStringList texts;
    for (const SurfaceEvaluation& surface : surfaces) {
      const VerifySentence sentence = surfaceText(surface, stated);
      all.tone = std::max(all.tone, sentence.tone);
      texts << (surfaces.size() + static_cast<std::size_t>(remarks.size()) > 1
                    ? tr("Patch %1. %2").arg(surface.patch.value() + 1).arg(sentence.text)
                    : sentence.text);
    }
    if (!remarks.isEmpty()) all.tone = std::max(all.tone, Tone::Caution);
    all.text = (texts + remarks).join(QLatin1Char('\n'));
    surface_->setSentence(all);
    surface_->setMetrics(surfaceMetrics(surfaces));
    emit surfaceShown(largestOf(surfaces));
  }

  void showComparison(const std::vector<Comparison>& comparisons, const QString& against) {
    comparison_->setSentence(comparisonText(comparisons, against));
    comparison_->setMetrics(comparisonMetrics(comparisons));
    emit comparisonShown(comparisons);
  }

  /// With the file that was chosen, until dropComparison(), whether it can be read or not.
  void compareWith(const QString& path) {
    compares_ = true;
    refreshControls();
    emit comparisonRequested(path);
  }

  void dropComparison() {
    compares_ = false;
    comparison_->clear();
    refreshControls();
    emit comparisonDropped();
    forget(VerifyCheck::Comparison);
  }

  void showOldCalibration(const CalibrationCheck& check, const QString& calibration) {
    if (!reconstruction_) return;
    old_->setSentence(oldCalibrationText(check, calibration));
    old_->setMetrics(oldCalibrationMetrics(check, *reconstruction_));
  }

  /// Whether the one in this file still holds, until dropOldCalibration().
  void checkOldCalibration(const QString& path) {
    old_calibration_ = path;
    refreshControls();
    requestOldCalibration();
  }

  void dropOldCalibration() {
    old_calibration_.clear();
    old_->clear();
    refreshControls();
    emit oldCalibrationDropped();
  }

  /// Shows a failure in place of an earlier result, which goes from the other views too.
  void showFailure(VerifyCheck check, const QString& message) {
    VerifySection* section = sectionOf(check);
    section->setMetrics({});
    section->setSentence({Tone::Bad, message});
    forget(check);
  }

  /// For the actions on its tables.
  [[nodiscard]] std::array<CsvActions*, 6> csvActions() const {
    std::array<CsvActions*, 6> actions{};
    std::ranges::transform(sections(), actions.begin(), &VerifySection::csvActions);
    return actions;
  }

 signals:
  void holdOutRequested(hexoderm::PoseId pose);
  void cancelRequested(hexoderm::VerifyCheck check);
  /// No kind: the most probable one.
  void surfaceRequested(std::optional<hexoderm::SurfaceKind> kind, std::optional<double> true_radius_m);
  void surfaceDropped();
  /// Which one, the window asks, and answers by compareWith().
  void comparisonFileWanted();
  void comparisonRequested(const QString& path);
  void comparisonDropped();
  /// Which one, the window asks, and answers by checkOldCalibration().
  void oldCalibrationWanted();
  /// With the newest `poses` poses of the session; no number: with all.
  void oldCalibrationRequested(const QString& path, std::optional<std::size_t> poses);
  void oldCalibrationDropped();

  /// Emitted with the things that the views draw; none: nothing any more. The surface is that of the largest patch,
  /// unless a row of another is picked.
  void surfaceShown(const std::optional<hexoderm::SurfaceEvaluation>& surface);
  void comparisonShown(const std::vector<hexoderm::Comparison>& comparisons);
  void loopShown(const std::optional<hexoderm::LoopEvaluation>& loop);

 private:
  void buildHoldOut() {
    makeNarrow(pose_);
    // Names of poses are long in some languages.
    hold_out_->addRow()->addWidget(pose_, 1);
    hold_out_->addRow({run_});
    connect(pose_, qOverload<int>(&QComboBox::activated), this, &VerifyPanel::refreshControls);
    connect(run_, &QPushButton::clicked, this,
            [this] { emit holdOutRequested(PoseId(pose_->currentData().toUInt())); });

    QHBoxLayout* rows = hold_out_->addRow();
    auto* group = new QButtonGroup(this);
    by_cell_ = addChoice(group, rows, "holdOutByCell", tr("By cell"));
    by_link_ = addChoice(group, rows, "holdOutByLink", tr("By link"));
    for (QToolButton* button : {by_cell_, by_link_}) {
      button->hide();
      connect(button, &QToolButton::clicked, this, &VerifyPanel::showHoldOutMetrics);
    }
    by_cell_->setChecked(true);
    rows->addStretch();
  }

  void buildSurface() {
    kind_->addItem(tr("None"), kNoSurface);
    kind_->addItem(tr("Most probable"), kAnySurface);
    for (const SurfaceKind kind : {SurfaceKind::Plane, SurfaceKind::Cylinder, SurfaceKind::Sphere, SurfaceKind::Cone}) {
      kind_->addItem(surfaceKindWord(kind), static_cast<int>(kind));
    }
    setUpLength(radius_mm_, 2, tr("not known"));
    auto* grid = new QGridLayout;
    grid->setColumnStretch(1, 1);
    addField(grid, 0, 0, tr("Surface"), kind_);
    addField(grid, 1, 0, tr("True radius"), radius_mm_);
    surface_->addRow()->addLayout(grid);
    connect(kind_, qOverload<int>(&QComboBox::currentIndexChanged), this, &VerifyPanel::requestSurface);
    connect(radius_mm_, qOverload<double>(&QDoubleSpinBox::valueChanged), this, &VerifyPanel::requestSurface);
  }

  void buildCaliper() {
    const auto makeCell = [this](QSpinBox* cell, const char* name, const QString& accessible_name) {
      setNames(cell, QLatin1String(name), accessible_name);
      cell->setRange(0, std::numeric_limits<int>::max());
      cell->setKeyboardTracking(false);
      cell->setGroupSeparatorShown(false);
      cell->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
      connect(cell, qOverload<int>(&QSpinBox::valueChanged), this, &VerifyPanel::checkCaliper);
    };
    makeCell(first_, "caliperFirst", tr("One cell"));
    makeCell(second_, "caliperSecond", tr("The other cell"));
    setUpLength(distance_mm_, 1, tr("not measured"));
    connect(distance_mm_, qOverload<double>(&QDoubleSpinBox::valueChanged), this, &VerifyPanel::checkCaliper);
    QGridLayout* grid = gridOfFields();
    addField(grid, 0, 0, tr("From cell"), first_);
    addField(grid, 0, 2, tr("to"), second_);
    addField(grid, 1, 0, tr("Measured"), distance_mm_, 3);
    caliper_->addRow()->addLayout(grid);
  }

  void buildComparison() {
    comparison_->addRow({choose_, drop_});
    connect(choose_, &QPushButton::clicked, this, &VerifyPanel::comparisonFileWanted);
    connect(drop_, &QPushButton::clicked, this, &VerifyPanel::dropComparison);
  }

  void buildOldCalibration() {
    makeNarrow(old_poses_);
    old_poses_->addItem(tr("The newest pose"), 1);
    for (int count = kUsualPoses; count <= kUsualPoses + 1; ++count) {
      old_poses_->addItem(tr("The newest %1 poses").arg(count), count);
    }
    old_poses_->addItem(tr("All poses"), kAllPoses);
    old_poses_->setCurrentIndex(old_poses_->findData(kUsualPoses));
    old_->addRow()->addWidget(old_poses_, 1);
    old_->addRow({choose_old_, drop_old_});
    connect(old_poses_, qOverload<int>(&QComboBox::currentIndexChanged), this, &VerifyPanel::requestOldCalibration);
    connect(choose_old_, &QPushButton::clicked, this, &VerifyPanel::oldCalibrationWanted);
    connect(drop_old_, &QPushButton::clicked, this, &VerifyPanel::dropOldCalibration);
  }

  void requestOldCalibration() {
    if (old_calibration_.isEmpty()) return;
    const int poses = old_poses_->currentData().toInt();
    emit oldCalibrationRequested(old_calibration_,
                                 poses == kAllPoses ? std::nullopt : std::optional(static_cast<std::size_t>(poses)));
  }

  /// `no_skin`: why there is none, in words.
  void refreshOldCalibration(const QString& no_skin) {
    const QString why = !reconstruction_ ? no_skin
                        : has_readings_
                            ? QString()
                            : tr("A calibration file holds no readings: open a session with the poses of today.");
    enable(choose_old_, why.isEmpty(), tr("A calibration, or a session that is then solved"), why);
    enable(old_poses_, why.isEmpty(),
           tr("Choose those that were taken since the calibration; disabled ones don't count"), why);
    drop_old_->setVisible(!old_calibration_.isEmpty());
    // A grey button alone would leave open why.
    if (old_calibration_.isEmpty()) old_->setSentence({Tone::Neutral, reconstruction_ ? why : QString()});
  }

  [[nodiscard]] VerifySection* sectionOf(VerifyCheck check) const {
    const std::array<VerifySection*, 5> of_checks = {hold_out_, loop_, surface_, comparison_, old_};
    return of_checks.at(static_cast<std::size_t>(check));
  }

  [[nodiscard]] std::array<VerifySection*, 6> sections() const {
    return {hold_out_, loop_, surface_, caliper_, comparison_, old_};
  }

  void requestSurface() {
    refreshControls();
    const int kind = kind_->currentData().toInt();
    if (kind == kNoSurface) {
      surface_->clear();
      forget(VerifyCheck::Surface);
      emit surfaceDropped();
      return;
    }
    const bool known = radius_mm_->isEnabled() && radius_mm_->value() > 0;
    emit surfaceRequested(kind == kAnySurface ? std::nullopt : std::optional(static_cast<SurfaceKind>(kind)),
                          known ? std::optional(radius_mm_->value() * kMillimetre) : std::nullopt);
  }

  /// The two cells that are proposed are far apart; others stay as long as they are there.
  void proposeCells() {
    if (!reconstruction_) return;
    const auto isThere = [this](const QSpinBox* cell) { return reconstruction_->find(cellIn(cell)).cell != nullptr; };
    if (isThere(first_) && isThere(second_)) return;
    const PatchReconstruction* patch = largestPatch(*reconstruction_);
    const auto cells = patch != nullptr ? farApart(*patch) : std::nullopt;
    if (!cells) return;
    // What was measured was another skin.
    const QSignalBlocker first(first_);
    const QSignalBlocker second(second_);
    const QSignalBlocker distance(distance_mm_);
    first_->setValue(static_cast<int>(cells->first.value()));
    second_->setValue(static_cast<int>(cells->second.value()));
    distance_mm_->setValue(0);
  }

  void checkCaliper() {
    if (!reconstruction_) return;
    if (distance_mm_->value() <= 0) {
      caliper_->setSentence(
          {Tone::Neutral, tr("Not measured yet: from the middle of one cell to the middle of the other, as straight as "
                             "the jaws reach.")});
      return;
    }
    try {
      caliper_->setSentence(distanceCheckText(
          checkDistance(*reconstruction_, cellIn(first_), cellIn(second_), distance_mm_->value() * kMillimetre)));
    } catch (const InvalidArgument& error) {
      caliper_->setSentence({Tone::Caution, words(error)});
    }
  }

  void refreshControls() {
    const QString no_skin = awaited_.isEmpty() ? tr("There is no skin yet.") : awaited_;
    QString why;
    if (!reconstruction_) {
      why = no_skin;
    } else if (!has_readings_) {
      why = tr("A calibration file holds no readings: open the session it was made of.");
    } else if (pose_->count() == 0) {
      why = tr("Takes %1 poses that are not disabled, and there is none yet.").arg(kFewestOtherPoses + 1);
    }
    pose_->setEnabled(why.isEmpty());
    if (why.isEmpty() && otherPoses() < kFewestOtherPoses) {
      why = tr("Takes %1 other poses that are not disabled; besides this one there are %2.")
                .arg(kFewestOtherPoses)
                .arg(otherPoses());
    }
    run_->setEnabled(why.isEmpty() && !hold_out_->isRunning());
    run_->setToolTip(
        why.isEmpty() ? tr("Solves without this pose and compares what the others predict with what was read") : why);
    pose_->setToolTip(why);
    // A grey button alone would leave open why.
    if (!why.isEmpty() && !hold_out_result_) hold_out_->setSentence({Tone::Neutral, why});
    if (why.isEmpty() && !hold_out_result_ && !hold_out_->isRunning()) {
      hold_out_->setSentence({Tone::Neutral, hold_out_outdated_ ? tr("The session has changed since: run it again.")
                                                                : tr("Not run yet.")});
    }

    const int kind = kind_->currentData().toInt();
    const bool round = kind == kAnySurface || kind == static_cast<int>(SurfaceKind::Cylinder) ||
                       kind == static_cast<int>(SurfaceKind::Sphere);
    const bool has_skin = reconstruction_ != nullptr;
    enable(kind_, has_skin, tr("Fitted through the centres of the cells"), no_skin);
    radius_mm_->setEnabled(reconstruction_ && round);
    radius_mm_->setToolTip(round ? tr("Known from a drawing or measured: the fit is then compared with it")
                                 : tr("Only a cylinder and a sphere have one radius to compare with."));
    enable(choose_, has_skin, tr("A calibration, or a session that is then solved"), no_skin);
    drop_->setVisible(compares_);
    refreshOldCalibration(no_skin);
    for (QWidget* field : std::initializer_list<QWidget*>{first_, second_, distance_mm_}) {
      enable(field, has_skin, tr("Cells far apart, across the bend, tell most"), no_skin);
    }
  }

  /// Number of poses left to solve with when the chosen pose is held out.
  [[nodiscard]] std::size_t otherPoses() const {
    const PoseId chosen(pose_->currentData().toUInt());
    return static_cast<std::size_t>(std::ranges::count_if(
        reconstruction_->poses, [chosen](const PoseSummary& pose) { return pose.enabled && pose.pose != chosen; }));
  }

  void showHoldOutMetrics() {
    const bool any = hold_out_result_ && !hold_out_result_->cells.empty();
    by_cell_->setVisible(any);
    by_link_->setVisible(any);
    hold_out_->setMetrics(any ? holdOutMetrics(*hold_out_result_, by_link_->isChecked()) : VerifyMetrics());
  }

  /// Drops the result of a check, here and from the other views.
  void forget(VerifyCheck check) {
    if (check == VerifyCheck::HoldOut) {
      hold_out_result_.reset();
      showHoldOutMetrics();
    } else if (check == VerifyCheck::Loops) {
      loops_.clear();
      emit loopShown(std::nullopt);
    } else if (check == VerifyCheck::Surface) {
      surfaces_.clear();
      emit surfaceShown(std::nullopt);
    } else if (check == VerifyCheck::Comparison) {
      emit comparisonShown({});
    }
  }

  std::shared_ptr<const Reconstruction> reconstruction_;
  QString awaited_;
  bool has_readings_ = true;
  std::optional<HoldOutResult> hold_out_result_;
  bool hold_out_outdated_ = false;  ///< there was a result, of an earlier state
  std::vector<FoundLoop> loops_;
  std::vector<SurfaceEvaluation> surfaces_;
  bool compares_ = false;    ///< a file is chosen
  QString old_calibration_;  ///< the file that is chosen; empty: none

  Selection* selection_;
  VerifySection* hold_out_ =
      new VerifySection(tr("Hold-out pose"), tr("Leave one pose out: do the others predict what it read?"),
                        QStringLiteral("holdOut"), selection_);
  VerifySection* loop_ =
      new VerifySection(tr("Loops"), tr("Do rings of cells close, link by link?"), QStringLiteral("loops"), selection_);
  VerifySection* surface_ = new VerifySection(tr("Surface"), tr("Do the cells lie on the surface they were put on?"),
                                              QStringLiteral("surface"), selection_);
  VerifySection* caliper_ =
      new VerifySection(tr("Distance by caliper"), tr("Does a distance measured on the skin itself agree?"),
                        QStringLiteral("caliper"), selection_);
  VerifySection* comparison_ =
      new VerifySection(tr("Compare with another calibration"), tr("Does another calibration of the same skin agree?"),
                        QStringLiteral("comparison"), selection_);
  VerifySection* old_ = new VerifySection(
      tr("Check an old calibration"),
      tr("Does one of some time ago still hold? Compared with the poses of this session, cell by cell."),
      QStringLiteral("oldCalibration"), selection_);
  QComboBox* pose_ = named(new QComboBox, "holdOutPose", tr("Pose that is held out"));
  QPushButton* run_ = named(new QPushButton(tr("Run")), "holdOutRun");
  QToolButton* by_cell_ = nullptr;
  QToolButton* by_link_ = nullptr;
  QComboBox* kind_ = named(new QComboBox, "surfaceKind", tr("Surface through the cells"));
  QDoubleSpinBox* radius_mm_ = named(new QDoubleSpinBox, "surfaceRadius", tr("True radius of the surface"));
  QSpinBox* first_ = new QSpinBox;
  QSpinBox* second_ = new QSpinBox;
  QDoubleSpinBox* distance_mm_ = named(new QDoubleSpinBox, "caliperDistance", tr("Measured distance"));
  QPushButton* choose_ = named(new QPushButton(tr("Choose file…")), "comparisonChoose");
  QPushButton* drop_ = named(new QPushButton(tr("Remove")), "comparisonRemove");
  QComboBox* old_poses_ =
      named(new QComboBox, "oldCalibrationPoses", tr("Poses that the old calibration is compared with"));
  QPushButton* choose_old_ =
      named(new QPushButton(tr("Choose file…")), "oldCalibrationChoose", tr("Choose the file of the old calibration"));
  QPushButton* drop_old_ =
      named(new QPushButton(tr("Remove")), "oldCalibrationRemove", tr("Remove the old calibration"));

  /// In the list of surfaces, besides the kinds.
  static constexpr int kNoSurface = -1;
  static constexpr int kAnySurface = -2;
  /// In the list of poses of today, besides their number.
  static constexpr int kAllPoses = 0;
  /// What an old calibration is compared with at first: as few as tell most, and none of its own where the session goes
  /// on with new ones.
  static constexpr int kUsualPoses = 2;
  static constexpr std::array kChecks = {VerifyCheck::HoldOut, VerifyCheck::Loops, VerifyCheck::Surface,
                                         VerifyCheck::Comparison, VerifyCheck::OldCalibration};

  static std::optional<SurfaceEvaluation> largestOf(const std::vector<SurfaceEvaluation>& surfaces) {
    const auto largest =
        std::ranges::max_element(surfaces, {}, [](const SurfaceEvaluation& surface) { return surface.cells.size(); });
    return largest == surfaces.end() ? std::nullopt : std::optional(*largest);
  }

  /// A length in millimetres, which is typed in place of `unknown`.
  static void setUpLength(QDoubleSpinBox* field, int decimals, const QString& unknown) {
    constexpr double kMax_mm = 100000;
    field->setRange(0, kMax_mm);
    field->setDecimals(decimals);
    field->setSuffix(VerifyPanel::tr(" mm"));
    field->setSpecialValueText(unknown);
    field->setKeyboardTracking(false);
    letTypingReplaceSpecialText(field);
  }

  static CellId cellIn(const QSpinBox* field) { return CellId(static_cast<std::uint32_t>(field->value())); }
};

}  // namespace hexoderm
