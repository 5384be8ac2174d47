#pragma once

#include "app/window/guide/actions.h"
#include "app/window/guide/guide.h"
#include "app/window/session/session_controller.h"
#include "app/window/settings/theme.h"
#include "app/window/toolkit/focus_order.h"
#include "widgets/controls/selection.h"

#include <QElapsedTimer>
#include <QMainWindow>
#include <QTimer>
#include <functional>
#include <memory>

class QLabel;
class QTableView;
class QModelIndex;
class QTabBar;

namespace hexoderm {

class Banner;
class CapturePanel;
class CaptureTone;
class CardDock;
class CheckList;
class CoverageView;
class CellTable;
class FindingTable;
class GraphView;
class LiveStrip;
class LinkTable;
class MessageBar;
class PatchView;
class PoseTable;
class ResidualView;
class StepPanel;
class StillnessView;
class WindowShell;
class Verification;
class VerifyPanel;

/// The one window. Wires the controller's signals to the views and the actions to the controller; decides nothing.
class MainWindow : public QMainWindow {
  Q_OBJECT

 public:
  explicit MainWindow(QWidget* parent = nullptr);
  ~MainWindow() override;

  [[nodiscard]] SessionController& controller() { return controller_; }
  [[nodiscard]] Selection& selection() { return selection_; }
  [[nodiscard]] const WindowActions& actions() const { return actions_; }
  /// The body of the step Verify.
  [[nodiscard]] VerifyPanel* verifyPanel() { return verify_panel_; }

  /// All ask first if poses would be lost.
  void openFile(const QString& path);
  void startDemo();
  void connectTo(const ConnectRequest& request);

  /// `remember`: also for the next start.
  void setThemeChoice(ThemeChoice choice, bool remember);
  [[nodiscard]] Theme theme() const { return theme_; }

  /// Log, recent and unsaved sessions, preferences.
  [[nodiscard]] WindowShell& shell() { return *shell_; }

  /// The whole window as it looks now. Waits for the 3D view to be up to date (PatchView::whenUpToDate()).
  [[nodiscard]] QImage picture();

 protected:
  void closeEvent(QCloseEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;
  bool focusNextPrevChild(bool next) override;
  // With the keyboard the window itself looks no different; QWidget's own would paint all that is in it anew.
  void focusInEvent(QFocusEvent* /*event*/) override {}
  void focusOutEvent(QFocusEvent* /*event*/) override {}

 private:
  void buildLayout();
  void buildStatusBar();
  QWidget* buildTopBar(const std::vector<QAction*>& panels);
  CardDock* buildDetails();
  void buildShell();
  void connectActions();
  void connectController();
  void connectSelection();
  void connectLive();
  void scrollIfScreenIsSmall();
  void connectVerify();
  void askForComparison();
  void connectCapture();
  void connectKeys();
  void showCoverage(const std::shared_ptr<const Reconstruction>& reconstruction);
  void showNextPose();
  void showAdvice();
  void showMoment();
  void followPart();
  void restoreLayout();
  void rememberLayout() const;

  void refresh();
  void refreshStatus();
  void showReconstruction(const std::shared_ptr<const Reconstruction>& reconstruction);
  void showPickedPose();
  void showPickedLink();
  void showPickedCell();
  void showReview(const std::shared_ptr<const Reconstruction>& reconstruction);
  void pickPose(PoseId pose);
  /// Rows of the tables and rows of their views, which may be sorted.
  [[nodiscard]] static int sourceRow(const QModelIndex& index);
  [[nodiscard]] static QModelIndex shownRow(const QTableView* view, int row);
  void pickFromFinding(int row);
  void showWorstFinding();
  void openStep(GuideStep step);
  [[nodiscard]] std::optional<int> pickedPoseRow() const;

  void refreshLive();
  void showConnectDialog();
  void askToOpen();
  void saveSession(bool always_ask);
  void askForPath(const QString& title, const QString& name, const QString& filter, const QString& extension,
                  std::function<void(QString)> chosen);
  void saveCalibration();
  void showExportDialog();
  void askForReport();
  QImage pictureAsDrawn();
  void savePicture();
  void saveGraph();
  void showDone(const QString& text, const QString& path);
  void afterAskingToSave(std::function<void()> proceed);
  void showGuide();
  void showAbout();
  [[nodiscard]] QString suggestedName() const;

  SessionController controller_;
  Selection selection_;
  WindowActions actions_;
  FocusOrder panes_;
  Theme theme_ = Theme::Light;
  std::unique_ptr<WindowShell> shell_;

  QMainWindow* docks_;  ///< holds the panels, so that banner and messages stay above them all
  Banner* banner_;
  MessageBar* message_bar_;
  LiveStrip* live_strip_;
  StepPanel* step_panel_;
  CheckList* check_list_;
  CapturePanel* capture_panel_;
  CoverageView* coverage_view_;
  StillnessView* stillness_view_;
  CaptureTone* tone_;
  PatchView* patch_view_;
  GraphView* graph_view_;
  PoseTable* pose_table_;
  LinkTable* link_table_;
  FindingTable* finding_table_;
  CellTable* cell_table_;
  QTableView* pose_view_;
  QTableView* link_view_;
  QTableView* finding_view_;
  QTableView* cell_view_;
  ResidualView* residual_view_;
  VerifyPanel* verify_panel_;
  Verification* verification_;
  QTabBar* detail_tabs_;
  CardDock* graph_dock_ = nullptr;
  CardDock* pose_dock_ = nullptr;
  CardDock* coverage_dock_ = nullptr;
  QLabel* session_name_;
  QLabel* source_status_;
  QLabel* losses_status_;
  QLabel* cells_status_;
  QLabel* solve_status_;
  QLabel* saved_status_;
  QLabel* said_status_;  ///< what went as it should, for a moment
  QTimer said_timer_;

  std::optional<PoseId> picked_pose_;
  std::optional<Eigen::Vector3d> current_up_;  ///< of the part just now, in the frame of the largest patch
  QElapsedTimer advice_age_;
  bool follows_part_ = false;
  std::uint64_t restarts_ = 0;          ///< of captures, as the recorder last said
  std::function<void()> after_saving_;  ///< what waits for the session to be on disk
  bool may_close_ = false;
  bool close_when_written_ = false;
};

}  // namespace hexoderm
