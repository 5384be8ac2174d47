#include "app/window/guide/actions.h"

#include "hexoderm/solve/metrics/assess.h"
#include "widgets/controls/panel_parts.h"
#include "widgets/words/words.h"

namespace hexoderm {
namespace {

/// The purpose of an action is kept apart from its tool tip, which gives the reason while the action can't be used.
constexpr const char* kPurpose = "purpose";

void allow(QAction* action, const QString& why_not) {
  const bool can = why_not.isEmpty();
  QString tip = can ? purposeOf(*action) : why_not;
  action->setStatusTip(tip);
  if (can && !action->shortcut().isEmpty()) {
    tip += QStringLiteral(" (%1)").arg(action->shortcut().toString(QKeySequence::NativeText));
  }
  action->setToolTip(tip);
  action->setEnabled(can);
}

}  // namespace

QString purposeOf(const QAction& action) { return action.property(kPurpose).toString(); }

QAction* WindowActions::make(const char* name, const QString& text, const QString& purpose,
                             const QList<QKeySequence>& shortcuts) const {
  auto* action = named(new QAction(text, owner_), name);
  action->setProperty(kPurpose, purpose);
  action->setShortcuts(shortcuts);
  owner_->addAction(action);
  allow(action, {});
  return action;
}

WindowActions::WindowActions(QWidget* owner, QUndoStack* undo_stack)
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
                              tr("Open this step"), {QKeySequence(QStringLiteral("Ctrl+%1").arg(number))}));
  }

  theme = {make("actionThemeSystem", tr("Like the &system"), tr("Light or dark, as the system asks for")),
           make("actionThemeLight", tr("&Light"), tr("Dark text on a light ground")),
           make("actionThemeDark", tr("&Dark"), tr("Light text on a dark ground"))};
  for (QAction* action : theme) {
    action->setCheckable(true);
    themes->addAction(action);
  }
}

void WindowActions::fillMenuBar(QMenuBar* bar, const std::vector<QAction*>& panels) const {
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
  edit->addActions({toggle_pose, delete_pose, recapture});
  edit->addAction(exclude_link);
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

void WindowActions::refreshCapture(const SessionController& controller, const QString& no_session) {
  const QString not_live = controller.liveSession().isLive() ? QString() : tr("No skin is connected");
  const QString no_skin = no_session.isEmpty() ? whyNoReadings(controller) : no_session;
  allow(capture, no_skin);
  QString no_advice = no_skin;
  if (no_advice.isEmpty() && !controller.liveSession().nextPose()) no_advice = tr("The next pose is being worked out");
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

QString WindowActions::whyNoReadings(const SessionController& controller) {
  const LiveSession& live = controller.liveSession();
  if (!live.isLive()) return tr("No skin is connected");
  if (live.source().status().state == SourceState::Streaming) return {};
  return tr("The skin does not send: %1").arg(words(live.source().status().message));
}

QString WindowActions::whyNoSession(const SessionController& controller) {
  if (controller.session()) return {};
  return controller.isEmpty() ? tr("Nothing is open yet")
                              : tr("A calibration is open: it holds the result, not the poses");
}

void WindowActions::refreshLink(const SessionController& controller, const std::optional<Selection::Link>& picked) {
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

void WindowActions::refreshSolving(const SessionController& controller) {
  allow(cancel_solving, controller.isSolving() ? QString() : tr("Nothing is being worked out"));
  allow(solve_again, controller.wasCancelled() ? QString() : tr("Nothing was stopped"));
}

void WindowActions::refreshRetake(const SessionController& controller) {
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

void WindowActions::refreshDevice(const SessionController& controller, std::optional<CellId> cell) {
  QString no_light;
  if (!controller.liveSession().isLive()) {
    no_light = tr("No skin is connected");
  } else if (!controller.liveSession().source().skin() || !controller.liveSession().source().skin()->can_light_cells) {
    no_light = tr("The cells of this device have no lights");
  } else if (!cell && !controller.liveSession().litCell()) {
    no_light = tr("Pick a cell first");
  }
  const std::optional<CellId> lit = controller.liveSession().litCell();
  light_cell->setChecked(lit.has_value());
  // A button shows no tick: its words say whether the light is on, and where.
  light_cell->setIconText(lit ? tr("Switch the light of cell %1 off").arg(lit->value()) : tr("Light the picked cell"));
  allow(light_cell, no_light);
}

void WindowActions::refresh(const SessionController& controller, std::optional<int> pose_row,
                            std::optional<CellId> cell) {
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
  allow(save, no_session);
  allow(save_as, no_session);
  allow(save_calibration, no_result);
  allow(export_to, no_result);
  allow(report, no_result);
  allow(report_title, no_result);

  QString no_pose = no_session;
  const std::optional<std::size_t> index = pose_row ? controller.sessionIndexOfPoseRow(*pose_row) : std::nullopt;
  if (no_pose.isEmpty() && !index) no_pose = tr("Pick a pose in the table of poses first");
  const bool disabled = index && session->poses()[*index].disabled;
  toggle_pose->setText(disabled ? tr("&Enable pose") : tr("&Disable pose"));
  allow(toggle_pose, no_pose);
  allow(delete_pose, no_pose);

  refreshCapture(controller, no_session);
  refreshSolving(controller);
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

}  // namespace hexoderm
