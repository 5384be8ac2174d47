#pragma once

#include <QObject>
#include <QString>
#include <optional>

class QTableView;

namespace hexoderm {

class GraphView;
class MessageBar;
class ReviewPresenter;
class Selection;
class SessionController;
class StepPanel;
class WindowActions;

/// Carries out the commands that change the pose, the link or the cell that is picked, or the pose that the assessment
/// picks.
class PickedCommands : public QObject {
  Q_OBJECT

 public:
  struct Views {
    StepPanel& steps;
    GraphView& graph;
    QTableView& links;
    MessageBar& messages;
  };
  /// All outlive this object.
  PickedCommands(const Views& views, SessionController& controller, WindowActions& actions, const Selection& selection,
                 const ReviewPresenter& review);

  /// Tells the actions of the window which of them can be used with what is picked.
  void refresh();

 private:
  void togglePose();
  void removePose();
  /// The pose at `index` of the session, or none any more, if it is that already.
  void recapturePose(std::optional<std::size_t> index);
  void muteLink();
  /// Of the picked pose among the session's.
  [[nodiscard]] std::optional<std::size_t> pickedPose() const;

  Views views_;
  SessionController& controller_;
  WindowActions& actions_;
  const Selection& selection_;
  const ReviewPresenter& review_;
  QString recapture_offer_;  ///< the message that offers to call the recapture off
};

}  // namespace hexoderm
