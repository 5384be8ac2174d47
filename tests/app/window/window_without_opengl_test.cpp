// A window on a machine that has no OpenGL, from its first message to a calibration.

#include "tests/app/window/window_test.h"
#include "widgets/patch/patch_captions.h"
#include "widgets/patch/patch_view.h"
#include "widgets/patch/scene_widget.h"

namespace hexoderm {
namespace {

class WindowWithoutOpenGlTest : public WindowTest {
 protected:
  void SetUp() override {
    ASSERT_FALSE(QOpenGLContext().create()) << "run by CTest, which sets QT_XCB_GL_INTEGRATION";
    software_ = qgetenv(kSoftware);
    qunsetenv(kSoftware);
    WindowTest::SetUp();
  }
  void TearDown() override {
    window_.reset();
    if (!software_.isEmpty()) qputenv(kSoftware, software_);
  }

  static constexpr const char* kSoftware = "LIBGL_ALWAYS_SOFTWARE";
  QByteArray software_;
};

TEST_F(WindowWithoutOpenGlTest, OffersToDrawByTheProcessorFromTheNextStartOn) {
  ASSERT_TRUE(waitForMessage("There is no OpenGL 3.2 here"));
  auto* button = find<QPushButton>("messageButton");
  EXPECT_EQ(button->text(), "Draw without the graphics card");
  EXPECT_FALSE(window_->preferences().isOn(Switch::SoftwareOpenGl));
  click(button);
  EXPECT_TRUE(window_->preferences().isOn(Switch::SoftwareOpenGl));
  EXPECT_TRUE(waitForMessage("Start Hexoderm again"));
}

TEST_F(WindowWithoutOpenGlTest, SaysSoWhereTheProcessorDrawsAlready) {
  window_.reset();
  qputenv(kSoftware, "1");
  openWindow();
  EXPECT_TRUE(waitForMessage("Drawing by the processor did not help either"));
}

TEST_F(WindowWithoutOpenGlTest, CalibratesAllTheSame) {
  EXPECT_EQ(window_->findChild<SceneWidget*>(), nullptr);
  const auto* captions = window_->findChild<PatchCaptions*>();
  EXPECT_THAT(captions->accessibleName(), HasTexts({"OpenGL", "Preferences, \"Draw without the graphics card\""}));
  ASSERT_NO_FATAL_FAILURE(takeDemoPoses(2));
  EXPECT_EQ(find<QTableView>("poseView")->model()->rowCount(), 2);
  EXPECT_EQ(find<QTableView>("linkView")->model()->rowCount(), 16);
  ASSERT_NO_FATAL_FAILURE(clickCellInGraph(CellId(5)));
  action("actionThemeDark")->trigger();
  action("actionFit")->trigger();
  action("actionSwapViews")->trigger();
  const QImage picture = window_->picture();
  auto* patch = window_->findChild<PatchView*>();
  const QPoint corner = picture.devicePixelRatio() * patch->mapTo(window_.get(), QPoint(20, patch->height() - 20));
  EXPECT_LT(picture.pixelColor(corner).lightness(), 60) << "the empty view has the theme of the others";
  keepPicture(picture, "without-opengl-dark");
  action("actionSwapViews")->trigger();
  action("actionUndo")->trigger();
  EXPECT_TRUE(waitForPoses(1));
  EXPECT_THAT(captions->accessibleName(), HasText("OpenGL"));
}

}  // namespace
}  // namespace hexoderm
