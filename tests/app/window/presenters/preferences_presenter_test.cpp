#include "tests/app/window/presenters/presenter_test.h"

namespace hexoderm {
namespace {

class PreferencesPresenterTest : public PresenterTest {};

TEST_F(PreferencesPresenterTest, PreferencesActAtOnceAndAreRemembered) {
  press(Qt::Key_Comma, Qt::ControlModifier);
  auto* dialog = waitForDialog("preferencesDialog");
  EXPECT_FALSE(dialog->isModal());
  EXPECT_EQ(QApplication::activeModalWidget(), nullptr);
  QSignalSpy solver(&window_->preferences(), &Preferences::solverOptionsChanged);
  QSignalSpy recorder(&window_->preferences(), &Preferences::recorderOptionsChanged);
  QSignalSpy tone(&window_->preferences(), &Preferences::switched);
  auto* tabs = dialog->findChild<QTabWidget*>("preferencesTabs");
  // Where an empty 3D view sends people.
  EXPECT_EQ(dialog->findChild<QAbstractButton*>("preferenceSoftwareOpenGl")->text().remove('&'),
            "Draw without the graphics card");

  auto* theme = dialog->findChild<QComboBox*>("preferenceTheme");
  EXPECT_EQ(theme->currentIndex(), 1);
  QTest::keyClick(theme, Qt::Key_Down);
  EXPECT_EQ(window_->theme(), Theme::Dark);

  tabs->setCurrentIndex(2);
  keepPicture(dialog->grab().toImage(), "preferences-solver-dark");
  auto* method = dialog->findChild<QComboBox*>("preferenceSolver");
  QTest::keyClick(method, Qt::Key_Down);
  ASSERT_EQ(solver.size(), 1);
  EXPECT_EQ(solver[0][0].value<SolverOptions>().solver, Solver::Tree);
  auto* gap = dialog->findChild<QComboBox*>("preferenceGapModel");
  QTest::keyClick(gap, Qt::Key_Down);
  EXPECT_EQ(window_->preferences().solverOptions().gap_model, GapModel::Arc);

  tabs->setCurrentIndex(1);
  keepPicture(dialog->grab().toImage(), "preferences-capture-dark");
  auto* excess = dialog->findChild<QDoubleSpinBox*>("preferenceExcess");
  EXPECT_DOUBLE_EQ(excess->value(), 30);
  excess->setFocus();
  excess->selectAll();
  QTest::keyClicks(excess, "45");
  EXPECT_TRUE(recorder.empty()) << "not at every digit";
  QTest::keyClick(excess, Qt::Key_Tab);
  ASSERT_EQ(recorder.size(), 1);
  EXPECT_DOUBLE_EQ(window_->preferences().recorderOptions().stillness.excess_limit_g, 0.045);
  EXPECT_DOUBLE_EQ(window_->preferences().recorderOptions().stillness.drift_limit_rad_s,
                   PoseRecorderOptions().stillness.drift_limit_rad_s);
  QTest::mouseClick(dialog->findChild<QCheckBox*>("preferenceTone"), Qt::LeftButton, Qt::NoModifier, QPoint(8, 8));
  EXPECT_EQ(tone.size(), 1);
  EXPECT_FALSE(window_->preferences().isOn(Switch::Tone));
  QTest::keyClick(dialog, Qt::Key_Escape);
  ASSERT_TRUE(waitUntilGone("preferencesDialog"));

  reopenWindow();
  EXPECT_EQ(window_->preferences().solverOptions().solver, Solver::Tree);
  EXPECT_EQ(window_->theme(), Theme::Dark);
  press(Qt::Key_Comma, Qt::ControlModifier);
  dialog = waitForDialog("preferencesDialog");
  click(dialog->findChild<QPushButton*>("preferencesDefaults"));
  EXPECT_EQ(window_->preferences().solverOptions().solver, Solver::Global);
  EXPECT_TRUE(window_->preferences().isOn(Switch::Tone));
  EXPECT_DOUBLE_EQ(dialog->findChild<QDoubleSpinBox*>("preferenceExcess")->value(), 30);
}

TEST_F(PreferencesPresenterTest, SettingsThatMakeNoSenseAreAsByDefault) {
  QSettings settings;
  settings.setValue("solver/gap_model", "rubber");
  settings.setValue("solver/class_threshold", -1);
  settings.setValue("capture/hold_s", 100);
  settings.setValue("view/text_factor", "huge");
  settings.setValue("view/language", "fr");
  const Preferences preferences;
  EXPECT_EQ(preferences.solverOptions().gap_model, GapModel::Fit);
  EXPECT_DOUBLE_EQ(preferences.solverOptions().class_threshold, 0.5);
  EXPECT_DOUBLE_EQ(preferences.recorderOptions().stillness.hold_s, 0.5);
  EXPECT_DOUBLE_EQ(preferences.textFactor(), 1);
  EXPECT_EQ(preferences.language(), "system");
}

TEST_F(PreferencesPresenterTest, TextGrowsByItsFactorAndGoesBack) {
  const double size = QApplication::font().pointSizeF();
  window_->preferences().setTextFactor(1.5);
  EXPECT_NEAR(QApplication::font().pointSizeF(), 1.5 * size, 0.1);
  keepPicture(window_->picture(), "welcome-text-150");
  window_->preferences().setTextFactor(1);
  EXPECT_NEAR(QApplication::font().pointSizeF(), size, 0.1);
}

}  // namespace
}  // namespace hexoderm
