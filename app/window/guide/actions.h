#pragma once

#include "app/window/session/session_controller.h"
#include "hexoderm/solve/metrics/assess.h"
#include "widgets/controls/panel_parts.h"
#include "widgets/controls/selection.h"
#include "widgets/words/words.h"

#include <QAction>
#include <QActionGroup>
#include <QCoreApplication>
#include <QMenu>
#include <QMenuBar>
#include <vector>

namespace hexoderm {

/// Everything the window can do, each with its key. An action that can't be used says why in its tool tip.
class WindowActions {
  Q_DECLARE_TR_FUNCTIONS(hexoderm::WindowActions)

  QWidget* owner_;  ///< first: the actions are made as its children

 public:
  /// Property of an action whose text changes: what it is called in a list of keys.
  static constexpr const char* kAlways = "always";
  /// The purpose of an action, also while its tool tip tells why it can't be used.
  static QString purposeOf(const QAction& action) { return action.property(kPurpose).toString(); }

  /// Creates the actions as children of `owner`, with their keys active in its window.
  WindowActions(QWidget* owner, QUndoStack* undo_stack)
      : owner_(owner),
        undo(undo_stack->createUndoAction(owner, tr("&Undo"))),
        redo(undo_stack->createRedoAction(owner, tr("&Redo"))),
        recent(new QMenu(tr("Open &recent"), owner)),
        themes(new QActionGroup(owner)) {
    undo->setObjectName(QStringLiteral("actionUndo"));
    redo->setObjectName(QStringLiteral("actionRedo"));
    retake->setProperty(kAlways, tr("Take a &pose again"));
    undo->setProperty(kAlways, tr("&Undo"));
    redo->setProperty(kAlways, tr("&Redo"));
    undo->setShortcut(QKeySequence::Undo);
    redo->setShortcuts({QKeySequence(QStringLiteral("Ctrl+Shift+Z")), QKeySequence(QStringLiteral("Ctrl+Y"))});
    owner->addActions({undo, redo});
    demo->setIconText(tr("Start the demo skin"));
    // A key that is held must not take a row of poses.
    for (QAction* action : {capture, automatic, skip_pose, turn, robot, live_mode, light_cell, toggle_pose, delete_pose,
                            recapture, retake, exclude_link, screenshot, swap_views, plot, compare}) {
      action->setAutoRepeat(false);
    }
    for (QAction* action : {automatic, robot, live_mode, light_cell}) action->setCheckable(true);
    constexpr int kSteps = 7;
    for (int number = 1; number <= kSteps; ++number) {
      go_to_step.push_back(make(qPrintable(QStringLiteral("actionStep%1").arg(number)), tr("Step &%1").arg(number),
                                tr("Open this step"), QStringLiteral("Ctrl+%1").arg(number)));
    }

    theme = {make("actionThemeSystem", tr("Like the &system"), tr("Light or dark, as the system asks for")),
             make("actionThemeLight", tr("&Light"), tr("Dark text on a light ground")),
             make("actionThemeDark", tr("&Dark"), tr("Light text on a dark ground"))};
    for (QAction* action : theme) {
      action->setCheckable(true);
      themes->addAction(action);
    }
  }

  QAction* demo = make("actionDemo", tr("Start the &demo skin"), tr("A simulated skin to try everything with"),
                       QStringLiteral("Ctrl+D"));
  QAction* robot_demo = make("actionRobotDemo", tr("Start the demo a&rm"),
                             tr("A forearm with two patches and an elbow: a session to place on its robot"));
  QAction* connect_skin =
      make("actionConnect", tr("&Connect to a skin…"), tr("Take poses of a skin that is connected, or of a recording"),
           QStringLiteral("Ctrl+K"));
  QAction* disconnect_skin =
      make("actionDisconnect", tr("D&isconnect"), tr("End the connection to the skin; what was captured stays"));
  QAction* open = make("actionOpen", tr("&Open…"), tr("Open a session or a calibration"), QKeySequence::Open);
  QAction* save = make("actionSave", tr("&Save session"), tr("Save the poses taken so far"), QKeySequence::Save);
  QAction* save_as = make("actionSaveAs", tr("Save session &as…"), tr("Save the session under another name"),
                          QStringLiteral("Ctrl+Shift+S"));
  QAction* save_calibration = make("actionSaveCalibration", tr("Save &calibration…"),
                                   tr("Save the reconstruction, complete enough to export and draw from it alone"));
  QAction* export_to = make("actionExport", tr("&Export…"), tr("Write the calibration in a form that others read"),
                            QStringLiteral("Ctrl+E"));
  QAction* report = make("actionReport", tr("&Report…"),
                         tr("Write a report with verdict, pictures and tables, as PDF or as a page for the browser"),
                         QStringLiteral("Ctrl+Shift+E"));
  QAction* report_title =
      make("actionReportTitle", tr("&Title of reports…"),
           tr("Robot, part, operator and notes, as they stand at the head of reports on this session"));
  QAction* quit = make("actionQuit", tr("&Quit"), tr("Close the window"), QStringLiteral("Ctrl+Q"));
  QAction* undo;
  QAction* redo;
  QAction* toggle_pose =
      make("actionTogglePose", tr("&Disable pose"), tr("Leave the picked pose out, or take it back"), Qt::Key_Delete);
  QAction* delete_pose = make("actionDeletePose", tr("De&lete pose"), tr("Take the picked pose out of the session"),
                              QStringLiteral("Shift+Del"));
  QAction* recapture = make("actionRecapture", tr("&Recapture pose"),
                            tr("The next capture takes the place of the picked pose"), Qt::Key_R);
  /// Recaptures the pose that the assessment wants again: "Take pose 2 again"
  QAction* retake = make("actionRetake", tr("Take a &pose again"),
                         tr("The next capture takes the place of the pose that keeps the result from being better"));
  /// "Set link aside", or "Take link back"
  QAction* exclude_link = make("actionExcludeLink", tr("Set link &aside"),
                               tr("Keep the picked link out of the solution, if it is a cable for example"), Qt::Key_M);
  QAction* capture = make("actionCapture", tr("Capture &now"),
                          tr("Take the next readings as a pose, whether the part is still or not"), Qt::Key_Space);
  QAction* automatic = make("actionAutomatic", tr("Capture by itself when &still"),
                            tr("Take a pose as soon as the part is held still after it was moved"), Qt::Key_A);
  QAction* skip_pose = make("actionSkipPose", tr("S&kip this pose"),
                            tr("The part can't be held like this: advise the next best pose"), Qt::Key_N);
  QAction* turn = make("actionTurn", tr("&Turn to the next pose"),
                       tr("Ask the device to turn itself to where the next pose helps most"), Qt::Key_T);
  /// Can be checked: the device turns itself from pose to pose
  QAction* robot = make("actionRobot", tr("Let the ro&bot take the poses"),
                        tr("The device turns itself from pose to pose until there are enough"), Qt::Key_B);
  QAction* live_mode =
      make("actionLiveMode", tr("&Live mode"), tr("Draw the skin from its readings of this moment alone"), Qt::Key_L);
  QAction* cancel_solving = make("actionCancelSolving", tr("Stop working it o&ut"),
                                 tr("Stop working out the last change; what is shown stays as it was before"));
  /// What was given up
  QAction* solve_again =
      make("actionSolveAgain", tr("&Work it out after all"), tr("Work out the result that was stopped before"));
  QAction* light_cell = make("actionLightCell", tr("Li&ght the picked cell"),
                             tr("Switch on the light of the picked cell on the skin itself"), QStringLiteral("Ctrl+L"));
  /// Shows where to look while holding the part
  QAction* show_next_pose =
      make("actionShowNextPose", tr("Show me the next pose"), tr("Open the step in which poses are captured"));
  /// The one that matters most
  QAction* show_finding = make("actionShowFinding", tr("Show what does not fit"),
                               tr("Pick the cell or link that the most serious finding is about"));
  QAction* find_cell =
      make("actionFindCell", tr("Find &cell…"), tr("Pick a cell by typing its ID"), QKeySequence::Find);
  /// Picks the least certain cell, and shows its figures
  QAction* worst_cell =
      make("actionWorstCell", tr("Worst ce&ll"),
           tr("Pick the cell that is known least certainly, and show its figures and its neighbours"), Qt::Key_W);
  /// Of what is picked, on a card
  QAction* figures =
      make("actionFigures", tr("F&igures of what is picked"),
           tr("Keep a card with all figures of the picked cell or link over the picture, or close it"), Qt::Key_I);
  QAction* fit = make("actionFit", tr("&Fit"), tr("Show the whole skin"), Qt::Key_F);
  QAction* front = make("actionFront", tr("F&ront view"), tr("Look at the patch from the front"));
  QAction* side = make("actionSide", tr("&Side view"), tr("Look at the patch from its side"));
  QAction* top = make("actionTop", tr("&Top view"), tr("Look at the patch from above"));
  QAction* back = make("actionBack", tr("Bac&k view"), tr("Look at the patch from behind"));
  QAction* isometric = make("actionIsometric", tr("&Isometric view"), tr("Look at the patch from between its axes"));
  QAction* screenshot =
      make("actionScreenshot", tr("&Picture of the window"), tr("Save a picture of this window"), Qt::Key_F12);
  /// F6, as Tab within one
  QAction* next_pane = make("actionNextPane", tr("&Next part of the window"),
                            tr("Take the keyboard to the next part: steps, pictures, tables"), Qt::Key_F6);
  QAction* previous_pane = make("actionPreviousPane", tr("Pre&vious part of the window"),
                                tr("Take the keyboard to the part before"), QStringLiteral("Shift+F6"));
  QAction* guide = make("actionGuide", tr("User &guide"), tr("How to calibrate a skin, page by page"), Qt::Key_F1);
  QAction* keys = make("actionKeys", tr("&Keys"), tr("The list of keys"), Qt::Key_H);
  QAction* about = make("actionAbout", tr("&About Hexoderm"), tr("Version and licence"));
  QAction* preferences =
      make("actionPreferences", tr("&Preferences…"),
           tr("Appearance, limits of the capture, options of the solver, folders"), QStringLiteral("Ctrl+,"));
  /// Graph and 3D view
  QAction* swap_views = make("actionSwapViews", tr("S&wap graph and 3D view"),
                             tr("The one in the middle goes to the side, and the other way round"), Qt::Key_G);
  QAction* reset_layout =
      make("actionResetLayout", tr("R&eset layout"), tr("Bring all panels back to where they were at the first start"));
  QAction* copy_report =
      make("actionCopyReport", tr("&Copy for a bug report"),
           tr("Versions, graphics, what is open and the last lines of the log, with your home folder as ~"));
  QAction* open_log_folder =
      make("actionOpenLogFolder", tr("&Open the log's folder"), tr("Show the folder in which the log is kept"));
  QAction* plot = make(
      "actionPlot", tr("P&lot of figures"),
      tr("Any figure of cells or links against any other; what is marked there is marked in all views"), Qt::Key_P);
  QAction* compare = make(
      "actionCompare", tr("Before and &after"),
      tr("The result of now beside an earlier one, seen from the same side, or with arrows between them"), Qt::Key_C);
  std::vector<QAction*> go_to_step;  ///< the first is step 1
  QMenu* recent;
  QActionGroup* themes;
  std::vector<QAction*> theme;  ///< in the order of ThemeChoice

  /// `panels`: the docks' own actions.
  void fillMenuBar(QMenuBar* bar, const std::vector<QAction*>& panels) const {
    QMenu* file = bar->addMenu(tr("&File"));
    file->addActions({demo, robot_demo, connect_skin, disconnect_skin, open});
    file->addMenu(recent);
    file->addSeparator();
    file->addActions({save, save_as, save_calibration, export_to, report, report_title});
    file->addSeparator();
    file->addAction(quit);

    QMenu* edit = bar->addMenu(tr("&Edit"));
    edit->addActions({undo, redo});
    edit->addSeparator();
    edit->addActions({toggle_pose, delete_pose, recapture, exclude_link});
    edit->addSeparator();
    edit->addAction(preferences);

    QMenu* session = bar->addMenu(tr("&Session"));
    session->addActions({show_next_pose, retake, capture, automatic, skip_pose});
    session->addSeparator();
    session->addActions({turn, robot});
    session->addSeparator();
    session->addActions({live_mode, light_cell});
    session->addSeparator();
    session->addActions({cancel_solving, solve_again});
    session->addSeparator();
    QMenu* steps = session->addMenu(tr("&Go to step"));
    for (QAction* step : go_to_step) steps->addAction(step);

    QMenu* view = bar->addMenu(tr("&View"));
    view->addActions({find_cell, worst_cell, figures, show_finding, fit, front, back, side, top, isometric, swap_views,
                      plot, compare});
    view->addSeparator();
    for (QAction* panel : panels) view->addAction(panel);
    view->addAction(reset_layout);
    view->addSeparator();
    view->addActions({next_pane, previous_pane});
    view->addSeparator();
    view->addMenu(tr("T&heme"))->addActions(themes->actions());
    view->addAction(screenshot);

    QMenu* help = bar->addMenu(tr("&Help"));
    help->addActions({guide, keys});
    help->addSeparator();
    help->addActions({copy_report, open_log_folder});
    help->addSeparator();
    help->addAction(about);
    for (QMenu* menu : {file, edit, session, steps, view, help}) menu->setToolTipsVisible(true);
  }

  /// Enables the actions that can be used now, and gives the reasons of the others. `pose_row`: the row picked in the
  /// table of poses.
  void refresh(const SessionController& controller, std::optional<int> pose_row, std::optional<CellId> cell) {
    const Session* session = controller.session();
    const QString no_session = whyNoSession(controller);
    QString no_result;
    if (!controller.reconstruction()) {
      no_result = controller.isEmpty() ? tr("Nothing is open yet") : tr("There is no reconstruction yet");
    } else if (controller.isSolving()) {
      no_result = tr("The reconstruction is being brought up to date");
    } else if (controller.wasCancelled()) {
      no_result = tr("Working out the last change was stopped; work it out after all first");
    } else if (!controller.isCurrent()) {
      no_result = tr("The last change could not be reconstructed; undo it first");
    }
    for (QAction* action : {save, save_as}) allow(action, no_session);
    for (QAction* action : {save_calibration, export_to, report, report_title}) allow(action, no_result);

    QString no_pose = no_session;
    const std::optional<std::size_t> index = pose_row ? controller.sessionIndexOfPoseRow(*pose_row) : std::nullopt;
    if (no_pose.isEmpty() && !index) no_pose = tr("Pick a pose in the table of poses first");
    const bool disabled = index && session->poses()[*index].disabled;
    toggle_pose->setText(disabled ? tr("&Enable pose") : tr("&Disable pose"));
    for (QAction* action : {toggle_pose, delete_pose}) allow(action, no_pose);

    refreshCapture(controller, no_session);
    allow(cancel_solving, controller.isSolving() ? QString() : tr("Nothing is being worked out"));
    allow(solve_again, controller.wasCancelled() ? QString() : tr("Nothing was stopped"));
    refreshDevice(controller, cell);
    QString no_recapture = no_pose;
    if (no_recapture.isEmpty() && !controller.liveSession().isLive()) no_recapture = tr("No skin is connected");
    const bool waits = index && controller.liveSession().recapturing() == session->poses()[*index].capture->id;
    recapture->setText(waits ? tr("Don't &recapture") : tr("&Recapture pose"));
    allow(recapture, no_recapture);
    refreshRetake(controller);
    const QString nothing = controller.reconstruction() ? QString() : tr("There is nothing to look at yet");
    const bool is_misfit = controller.reconstruction() && worstFinding(*controller.reconstruction()) != nullptr;
    allow(show_finding, is_misfit || !nothing.isEmpty() ? nothing : tr("Nothing was found that does not fit"));
    for (QAction* action : {plot, compare}) allow(action, nothing);
    const QString no_picture = controller.firstPlacements() ? QString() : nothing;
    for (QAction* action : {find_cell, figures, fit, front, back, side, top, isometric}) allow(action, no_picture);
    const bool is_stated = controller.reconstruction() && controller.reconstruction()->assessment.position_95_m;
    allow(worst_cell, nothing.isEmpty() && !is_stated ? tr("How certain the cells are is not known yet") : nothing);
    for (QAction* action : {undo, redo}) {
      const bool can = action->isEnabled();
      const QString tip = can ? action->text().remove(QLatin1Char('&'))
                              : (action == undo ? tr("Nothing to undo") : tr("Nothing to redo"));
      action->setToolTip(tip);
      action->setStatusTip(tip);
    }
  }

  /// The same for the actions on a link. `picked`: the selected link.
  void refreshLink(const SessionController& controller, const std::optional<Selection::Link>& picked) {
    QString no_link = whyNoSession(controller);
    if (no_link.isEmpty() && !picked) no_link = tr("Pick a link in the graph or in the table of links first");
    const bool excluded =
        no_link.isEmpty() && controller.session()->findMutedLink(picked->first, picked->second) != nullptr;
    exclude_link->setText(excluded ? tr("Take link b&ack") : tr("Set link &aside"));
    exclude_link->setProperty(kPurpose,
                              excluded ? tr("Let the picked link into the solution again")
                                       : tr("Keep the picked link out of the solution, if it is a cable for example"));
    allow(exclude_link, no_link);
  }

 private:
  /// The purpose of an action is kept apart from its tool tip, which gives the reason while the action can't be used.
  static constexpr const char* kPurpose = "purpose";

  static void allow(QAction* action, const QString& why_not) {
    const bool can = why_not.isEmpty();
    QString tip = can ? purposeOf(*action) : why_not;
    action->setStatusTip(tip);
    if (can && !action->shortcut().isEmpty()) {
      tip += QStringLiteral(" (%1)").arg(action->shortcut().toString(QKeySequence::NativeText));
    }
    action->setToolTip(tip);
    action->setEnabled(can);
  }

  QAction* make(const char* name, const QString& text, const QString& purpose,
                const QKeySequence& shortcut = {}) const {
    auto* action = named(new QAction(text, owner_), name);
    action->setProperty(kPurpose, purpose);
    action->setShortcut(shortcut);
    owner_->addAction(action);
    allow(action, {});
    return action;
  }

  [[nodiscard]] static QString whyNoSession(const SessionController& controller) {
    if (controller.session()) return {};
    return controller.isEmpty() ? tr("Nothing is open yet")
                                : tr("A calibration is open: it holds the result, not the poses");
  }

  [[nodiscard]] static QString whyNoReadings(const SessionController& controller) {
    const LiveSession& live = controller.liveSession();
    if (!live.isLive()) return tr("No skin is connected");
    if (live.source().status().state == SourceState::Streaming) return {};
    return tr("The skin does not send: %1").arg(words(live.source().status().message));
  }

  void refreshCapture(const SessionController& controller, const QString& no_session) {
    const QString not_live = controller.liveSession().isLive() ? QString() : tr("No skin is connected");
    const QString no_skin = no_session.isEmpty() ? whyNoReadings(controller) : no_session;
    allow(capture, no_skin);
    QString no_advice = no_skin;
    if (no_advice.isEmpty() && !controller.liveSession().nextPose()) {
      no_advice = tr("The next pose is being worked out");
    }
    allow(show_next_pose, no_advice);
    QString not_wanted;
    if (controller.liveSession().nextPose() && !controller.liveSession().isNextPoseWanted()) {
      // After a capture the advice from before it is still there for a moment.
      not_wanted = controller.enabledPoses() == 0 ? tr("Any way up will do for the first pose")
                   : controller.liveSession().wantsMorePoses()
                       ? tr("The next pose is being worked out")
                       : tr("There are enough poses; turn and capture more by hand if you like");
    }
    allow(skip_pose, no_advice.isEmpty() ? not_wanted : no_advice);
    QString no_robot = no_skin;
    if (no_robot.isEmpty() && !controller.liveSession().canTurn()) {
      no_robot = tr("This device can't turn itself; turn the part by hand");
    }
    robot->setChecked(controller.liveSession().isRobotOn());
    const QString who = controller.liveSession().isDemo() ? tr("Let the simulated robot take the poses")
                                                          : tr("Let the robot take the poses");
    robot->setIconText(controller.liveSession().isRobotOn() ? tr("Stop the robot") : who);
    QString no_more = no_robot;
    if (no_more.isEmpty() && !controller.liveSession().isRobotOn() && !controller.liveSession().wantsMorePoses()) {
      no_more = tr("There are enough poses; turn and capture more by hand if you like");
    }
    allow(robot, no_more);
    if (no_robot.isEmpty() && !controller.liveSession().nextPose()) no_robot = tr("The next pose is being worked out");
    // Where there are enough poses, whoever wants a better result still can turn to another one.
    const bool are_enough = controller.enabledPoses() > 0 && !controller.liveSession().wantsMorePoses();
    allow(turn, no_robot.isEmpty() && !are_enough ? not_wanted : no_robot);
    automatic->setChecked(controller.liveSession().isAutomatic());
    allow(automatic, not_live);
    allow(disconnect_skin, controller.liveSession().source().isRunning() ? QString() : tr("No skin is connected"));
    const bool is_tried = controller.liveSession().source().isRunning() && !not_live.isEmpty();
    connect_skin->setIconText(is_tried ? tr("Correct the address…") : QString());
    live_mode->setChecked(controller.liveMode().isOn());
    live_mode->setIconText(controller.liveMode().isOn() ? tr("End live mode") : tr("Live mode"));
    allow(live_mode, not_live);
  }

  void refreshRetake(const SessionController& controller) {
    const LiveSession& live = controller.liveSession();
    const std::optional<std::size_t> index = controller.indexToRetake();
    retake->setText(tr("Take a &pose again"));
    if (!index) {
      allow(retake, tr("No pose has to be taken again"));
      return;
    }
    const PoseId pose = controller.session()->poses()[*index].capture->id;
    retake->setText(live.recapturing() == pose ? tr("Don't take &pose %1 again").arg(pose.value())
                                               : tr("Take &pose %1 again").arg(pose.value()));
    allow(retake, whyNoReadings(controller));
  }

  void refreshDevice(const SessionController& controller, std::optional<CellId> cell) {
    QString no_light;
    if (!controller.liveSession().isLive()) {
      no_light = tr("No skin is connected");
    } else if (!controller.liveSession().source().skin() ||
               !controller.liveSession().source().skin()->can_light_cells) {
      no_light = tr("The cells of this device have no lights");
    } else if (!cell && !controller.liveSession().litCell()) {
      no_light = tr("Pick a cell first");
    }
    const std::optional<CellId> lit = controller.liveSession().litCell();
    light_cell->setChecked(lit.has_value());
    // A button shows no tick: its words say whether the light is on, and where.
    light_cell->setIconText(lit ? tr("Switch the light of cell %1 off").arg(lit->value())
                                : tr("Light the picked cell"));
    allow(light_cell, no_light);
  }
};

}  // namespace hexoderm
