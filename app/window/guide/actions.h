#pragma once

#include "app/window/session/session_controller.h"
#include "app/window/settings/theme.h"
#include "widgets/controls/selection.h"

#include <QAction>
#include <QActionGroup>
#include <QCoreApplication>
#include <QMenu>
#include <QMenuBar>
#include <vector>

namespace hexoderm {

/// The purpose of an action, also while its tool tip tells why it can't be used.
QString purposeOf(const QAction& action);

/// Everything the window can do, each with its key. An action that can't be used says why in its tool tip.
class WindowActions {
  Q_DECLARE_TR_FUNCTIONS(hexoderm::WindowActions)

  QWidget* owner_;  ///< first: the actions are made as its children

 public:
  /// Property of an action whose text changes: what it is called in a list of keys.
  static constexpr const char* kAlways = "always";

  /// Creates the actions as children of `owner`, with their keys active in its window.
  WindowActions(QWidget* owner, QUndoStack* undo_stack);

  QAction* demo = make("actionDemo", tr("Start the &demo skin"), tr("A simulated skin to try everything with"),
                       {QKeySequence(QStringLiteral("Ctrl+D"))});
  QAction* robot_demo = make("actionRobotDemo", tr("Start the demo a&rm"),
                             tr("A forearm with two patches and an elbow: a session to place on its robot"));
  QAction* connect_skin =
      make("actionConnect", tr("&Connect to a skin…"), tr("Take poses of a skin that is connected, or of a recording"),
           {QKeySequence(QStringLiteral("Ctrl+K"))});
  QAction* disconnect_skin =
      make("actionDisconnect", tr("D&isconnect"), tr("End the connection to the skin; what was captured stays"));
  QAction* open = make("actionOpen", tr("&Open…"), tr("Open a session or a calibration"), {QKeySequence::Open});
  QAction* save = make("actionSave", tr("&Save session"), tr("Save the poses taken so far"), {QKeySequence::Save});
  QAction* save_as = make("actionSaveAs", tr("Save session &as…"), tr("Save the session under another name"),
                          {QKeySequence(QStringLiteral("Ctrl+Shift+S"))});
  QAction* save_calibration = make("actionSaveCalibration", tr("Save &calibration…"),
                                   tr("Save the reconstruction, complete enough to export and draw from it alone"));
  QAction* export_to = make("actionExport", tr("&Export…"), tr("Write the calibration in a form that others read"),
                            {QKeySequence(QStringLiteral("Ctrl+E"))});
  QAction* report = make("actionReport", tr("&Report…"),
                         tr("Write a report with verdict, pictures and tables, as PDF or as a page for the browser"),
                         {QKeySequence(QStringLiteral("Ctrl+Shift+E"))});
  QAction* report_title =
      make("actionReportTitle", tr("&Title of reports…"),
           tr("Robot, part, operator and notes, as they stand at the head of reports on this session"));
  QAction* quit = make("actionQuit", tr("&Quit"), tr("Close the window"), {QKeySequence(QStringLiteral("Ctrl+Q"))});
  QAction* undo;
  QAction* redo;
  QAction* toggle_pose = make("actionTogglePose", tr("&Disable pose"), tr("Leave the picked pose out, or take it back"),
                              {QKeySequence(Qt::Key_Delete)});
  QAction* delete_pose = make("actionDeletePose", tr("De&lete pose"), tr("Take the picked pose out of the session"),
                              {QKeySequence(QStringLiteral("Shift+Del"))});
  QAction* recapture = make("actionRecapture", tr("&Recapture pose"),
                            tr("The next capture takes the place of the picked pose"), {QKeySequence(Qt::Key_R)});
  /// Recaptures the pose that the assessment wants again: "Take pose 2 again"
  QAction* retake = make("actionRetake", tr("Take a &pose again"),
                         tr("The next capture takes the place of the pose that keeps the result from being better"));
  /// "Set link aside", or "Take link back"
  QAction* exclude_link =
      make("actionExcludeLink", tr("Set link &aside"),
           tr("Keep the picked link out of the solution, if it is a cable for example"), {QKeySequence(Qt::Key_M)});
  QAction* capture =
      make("actionCapture", tr("Capture &now"),
           tr("Take the next readings as a pose, whether the part is still or not"), {QKeySequence(Qt::Key_Space)});
  QAction* automatic =
      make("actionAutomatic", tr("Capture by itself when &still"),
           tr("Take a pose as soon as the part is held still after it was moved"), {QKeySequence(Qt::Key_A)});
  QAction* skip_pose =
      make("actionSkipPose", tr("S&kip this pose"), tr("The part can't be held like this: advise the next best pose"),
           {QKeySequence(Qt::Key_N)});
  QAction* turn =
      make("actionTurn", tr("&Turn to the next pose"),
           tr("Ask the device to turn itself to where the next pose helps most"), {QKeySequence(Qt::Key_T)});
  /// Can be checked: the device turns itself from pose to pose
  QAction* robot =
      make("actionRobot", tr("Let the ro&bot take the poses"),
           tr("The device turns itself from pose to pose until there are enough"), {QKeySequence(Qt::Key_B)});
  QAction* live_mode = make("actionLiveMode", tr("&Live mode"),
                            tr("Draw the skin from its readings of this moment alone"), {QKeySequence(Qt::Key_L)});
  QAction* cancel_solving = make("actionCancelSolving", tr("Stop working it o&ut"),
                                 tr("Stop working out the last change; what is shown stays as it was before"));
  /// What was given up
  QAction* solve_again =
      make("actionSolveAgain", tr("&Work it out after all"), tr("Work out the result that was stopped before"));
  QAction* light_cell =
      make("actionLightCell", tr("Li&ght the picked cell"),
           tr("Switch on the light of the picked cell on the skin itself"), {QKeySequence(QStringLiteral("Ctrl+L"))});
  /// Shows where to look while holding the part
  QAction* show_next_pose =
      make("actionShowNextPose", tr("Show me the next pose"), tr("Open the step in which poses are captured"));
  /// The one that matters most
  QAction* show_finding = make("actionShowFinding", tr("Show what does not fit"),
                               tr("Pick the cell or link that the most serious finding is about"));
  QAction* find_cell =
      make("actionFindCell", tr("Find &cell…"), tr("Pick a cell by typing its ID"), {QKeySequence::Find});
  /// Picks the least certain cell, and shows its figures
  QAction* worst_cell = make("actionWorstCell", tr("Worst ce&ll"),
                             tr("Pick the cell that is known least certainly, and show its figures and its neighbours"),
                             {QKeySequence(Qt::Key_W)});
  /// Of what is picked, on a card
  QAction* figures = make("actionFigures", tr("F&igures of what is picked"),
                          tr("Keep a card with all figures of the picked cell or link over the picture, or close it"),
                          {QKeySequence(Qt::Key_I)});
  QAction* fit = make("actionFit", tr("&Fit"), tr("Show the whole skin"), {QKeySequence(Qt::Key_F)});
  QAction* front = make("actionFront", tr("F&ront view"), tr("Look at the patch from the front"));
  QAction* side = make("actionSide", tr("&Side view"), tr("Look at the patch from its side"));
  QAction* top = make("actionTop", tr("&Top view"), tr("Look at the patch from above"));
  QAction* back = make("actionBack", tr("Bac&k view"), tr("Look at the patch from behind"));
  QAction* isometric = make("actionIsometric", tr("&Isometric view"), tr("Look at the patch from between its axes"));
  QAction* screenshot = make("actionScreenshot", tr("&Picture of the window"), tr("Save a picture of this window"),
                             {QKeySequence(Qt::Key_F12)});
  /// F6, as Tab within one
  QAction* next_pane =
      make("actionNextPane", tr("&Next part of the window"),
           tr("Take the keyboard to the next part: steps, pictures, tables"), {QKeySequence(Qt::Key_F6)});
  QAction* previous_pane = make("actionPreviousPane", tr("Pre&vious part of the window"),
                                tr("Take the keyboard to the part before"), {QKeySequence(QStringLiteral("Shift+F6"))});
  QAction* guide =
      make("actionGuide", tr("User &guide"), tr("How to calibrate a skin, page by page"), {QKeySequence(Qt::Key_F1)});
  QAction* keys = make("actionKeys", tr("&Keys"), tr("The list of keys"), {QKeySequence(Qt::Key_H)});
  QAction* about = make("actionAbout", tr("&About Hexoderm"), tr("Version and licence"));
  QAction* preferences = make("actionPreferences", tr("&Preferences…"),
                              tr("Appearance, limits of the capture, options of the solver, folders"),
                              {QKeySequence(QStringLiteral("Ctrl+,"))});
  /// Graph and 3D view
  QAction* swap_views =
      make("actionSwapViews", tr("S&wap graph and 3D view"),
           tr("The one in the middle goes to the side, and the other way round"), {QKeySequence(Qt::Key_G)});
  QAction* reset_layout =
      make("actionResetLayout", tr("R&eset layout"), tr("Bring all panels back to where they were at the first start"));
  QAction* copy_report =
      make("actionCopyReport", tr("&Copy for a bug report"),
           tr("Versions, graphics, what is open and the last lines of the log, with your home folder as ~"));
  QAction* open_log_folder =
      make("actionOpenLogFolder", tr("&Open the log's folder"), tr("Show the folder in which the log is kept"));
  QAction* plot =
      make("actionPlot", tr("P&lot of figures"),
           tr("Any figure of cells or links against any other; what is marked there is marked in all views"),
           {QKeySequence(Qt::Key_P)});
  QAction* compare =
      make("actionCompare", tr("Before and &after"),
           tr("The result of now beside an earlier one, seen from the same side, or with arrows between them"),
           {QKeySequence(Qt::Key_C)});
  std::vector<QAction*> go_to_step;  ///< the first is step 1
  QMenu* recent;
  QActionGroup* themes;
  std::vector<QAction*> theme;  ///< in the order of ThemeChoice

  /// `panels`: the docks' own actions.
  void fillMenuBar(QMenuBar* bar, const std::vector<QAction*>& panels) const;

  /// Enables the actions that can be used now, and gives the reasons of the others. `pose_row`: the row picked in the
  /// table of poses.
  void refresh(const SessionController& controller, std::optional<int> pose_row, std::optional<CellId> cell);
  /// The same for the actions on a link. `picked`: the selected link.
  void refreshLink(const SessionController& controller, const std::optional<Selection::Link>& picked);

 private:
  QAction* make(const char* name, const QString& text, const QString& purpose,
                const QList<QKeySequence>& shortcuts = {}) const;
  [[nodiscard]] static QString whyNoSession(const SessionController& controller);
  [[nodiscard]] static QString whyNoReadings(const SessionController& controller);
  void refreshCapture(const SessionController& controller, const QString& no_session);
  void refreshSolving(const SessionController& controller);
  void refreshRetake(const SessionController& controller);
  void refreshDevice(const SessionController& controller, std::optional<CellId> cell);
};

}  // namespace hexoderm
