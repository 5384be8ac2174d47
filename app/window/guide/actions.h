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

 public:
  /// Property of an action whose text changes: what it is called in a list of keys.
  static constexpr const char* kAlways = "always";

  /// Creates the actions as children of `owner`, with their keys active in its window.
  WindowActions(QWidget* owner, QUndoStack* undo_stack);

  QAction* demo;
  QAction* robot_demo;
  QAction* connect_skin;
  QAction* disconnect_skin;
  QAction* open;
  QAction* save;
  QAction* save_as;
  QAction* save_calibration;
  QAction* export_to;
  QAction* report;
  QAction* report_title;
  QAction* quit;
  QAction* undo;
  QAction* redo;
  QAction* toggle_pose;
  QAction* delete_pose;
  QAction* recapture;
  QAction* retake;     ///< recaptures the pose that the assessment wants again: "Take pose 2 again"
  QAction* mute_link;  ///< "Set link aside", or "Take link back"
  QAction* capture;
  QAction* automatic;
  QAction* skip_pose;
  QAction* turn;
  QAction* robot;  ///< can be checked: the device turns itself from pose to pose
  QAction* live_mode;
  QAction* cancel_solving;
  QAction* solve_again;  ///< what was given up
  QAction* light_cell;
  QAction* show_next_pose;  ///< shows where to look while holding the part
  QAction* show_finding;    ///< the one that matters most
  QAction* find_cell;
  QAction* worst_cell;  ///< picks the least certain cell, and shows its figures
  QAction* figures;     ///< of what is picked, on a card
  QAction* fit;
  QAction* front;
  QAction* side;
  QAction* top;
  QAction* back;
  QAction* isometric;
  QAction* screenshot;
  QAction* next_pane;  ///< F6, as Tab within one
  QAction* previous_pane;
  QAction* guide;
  QAction* keys;
  QAction* about;
  QAction* preferences;
  QAction* swap_views;  ///< graph and 3D view
  QAction* reset_layout;
  QAction* copy_report;
  QAction* open_log_folder;
  QAction* plot;
  QAction* compare;
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
  [[nodiscard]] static QString whyNoSession(const SessionController& controller);
  void refreshCapture(const SessionController& controller, const QString& no_session);
  void refreshSolving(const SessionController& controller);
  void refreshRetake(const SessionController& controller);
  void refreshDevice(const SessionController& controller, std::optional<CellId> cell);
};

}  // namespace hexoderm
