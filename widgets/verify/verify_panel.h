#pragma once

#include "widgets/verify/verify_section.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QPushButton>
#include <QSpinBox>
#include <QStringList>
#include <QToolButton>
#include <QWidget>
#include <array>
#include <memory>
#include <optional>

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
  explicit VerifyPanel(Selection* selection, QWidget* parent = nullptr);

  /// Sets the calibration to verify; results about an earlier state of it go.
  void setReconstruction(std::shared_ptr<const Reconstruction> reconstruction);
  /// Whether there is a session that a pose can be held out of, as there is none for a calibration; there is at first.
  void setHasReadings(bool has_readings);
  /// What is going on while there is no skin, in words; empty: nothing is.
  void setAwaited(const QString& awaited);
  void setRunning(VerifyCheck check, bool running);

  void showHoldOut(const HoldOutResult& result);
  void showLoops(const std::vector<FoundLoop>& loops);
  /// One a patch; `remarks` say why there is none of another.
  void showSurfaces(const std::vector<SurfaceEvaluation>& surfaces, const QStringList& remarks);
  void showComparison(const std::vector<Comparison>& comparisons, const QString& against);
  /// With the file that was chosen, until dropComparison(), whether it can be read or not.
  void compareWith(const QString& path);
  void dropComparison();
  void showOldCalibration(const CalibrationCheck& check, const QString& calibration);
  /// Whether the one in this file still holds, until dropOldCalibration().
  void checkOldCalibration(const QString& path);
  void dropOldCalibration();
  /// Shows a failure in place of an earlier result, which goes from the other views too.
  void showFailure(VerifyCheck check, const QString& message);

  /// For the actions on its tables.
  [[nodiscard]] std::array<CsvActions*, 6> csvActions() const;

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
  void buildHoldOut();
  void buildSurface();
  void buildCaliper();
  void buildComparison();
  void buildOldCalibration();
  void requestOldCalibration();
  /// `no_skin`: why there is none, in words.
  void refreshOldCalibration(const QString& no_skin);
  [[nodiscard]] VerifySection* sectionOf(VerifyCheck check) const;
  [[nodiscard]] std::array<VerifySection*, 6> sections() const;
  void requestSurface();
  void proposeCells();
  void checkCaliper();
  void refreshControls();
  [[nodiscard]] std::size_t otherPoses() const;
  void showHoldOutMetrics();
  void forget(VerifyCheck check);

  std::shared_ptr<const Reconstruction> reconstruction_;
  QString awaited_;
  bool has_readings_ = true;
  std::optional<HoldOutResult> hold_out_result_;
  bool hold_out_outdated_ = false;  ///< there was a result, of an earlier state
  std::vector<FoundLoop> loops_;
  std::vector<SurfaceEvaluation> surfaces_;
  bool compares_ = false;    ///< a file is chosen
  QString old_calibration_;  ///< the file that is chosen; empty: none

  VerifySection* hold_out_;
  VerifySection* loop_;
  VerifySection* surface_;
  VerifySection* caliper_;
  VerifySection* comparison_;
  VerifySection* old_;
  QComboBox* pose_ = new QComboBox;
  QPushButton* run_ = new QPushButton(tr("Run"));
  QToolButton* by_cell_ = nullptr;
  QToolButton* by_link_ = nullptr;
  QComboBox* kind_ = new QComboBox;
  QDoubleSpinBox* radius_mm_ = new QDoubleSpinBox;
  QSpinBox* first_ = new QSpinBox;
  QSpinBox* second_ = new QSpinBox;
  QDoubleSpinBox* distance_mm_ = new QDoubleSpinBox;
  QPushButton* choose_ = new QPushButton(tr("Choose file…"));
  QPushButton* drop_ = new QPushButton(tr("Remove"));
  QComboBox* old_poses_ = new QComboBox;
  QPushButton* choose_old_ = new QPushButton(tr("Choose file…"));
  QPushButton* drop_old_ = new QPushButton(tr("Remove"));
};

}  // namespace hexoderm
