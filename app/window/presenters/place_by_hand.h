#pragma once

#include "app/window/session/place_facts.h"

#include <QObject>
#include <optional>

namespace hexoderm {

class PlacePanel;
struct PlaceFaults;
class RobotView;
class SessionController;

/// Moves the patch that the step "Place on the robot" is about by hand: takes it at the operator's word, moves it as
/// it is pulled in the view, and lays it for the fit to begin there.
class PlaceByHand : public QObject {
  Q_OBJECT

 public:
  /// All outlive this.
  PlaceByHand(PlacePanel& panel, RobotView& view, const SessionController& controller, PlaceFacts& facts,
              PlaceFaults& faults);

  [[nodiscard]] const HandPlace& hand() const { return hand_; }
  /// By what the patch is moved by hand; nullopt: it can't be.
  [[nodiscard]] std::optional<HandPlace::Where> handle() const;
  /// Leaves the patch alone if what it is moved by has changed.
  void follow();
  void leaveAlone();

 signals:
  /// The patch is elsewhere, or it could not be taken: it is to be shown anew.
  void moved();
  /// The facts say where the patch was put.
  void put();
  /// The patch is not held any more; before, put() came if it had been moved.
  void laid();

 private:
  /// Whether there is anything to be moved.
  bool takeInHand();
  template <class Move>
  void moveInHand(Move move);
  /// It is to lie where it is: the fit begins there, and what comes of it becomes the place.
  void lay();

  PlacePanel& panel_;
  RobotView& view_;
  const SessionController& controller_;
  PlaceFacts& facts_;
  PlaceFaults& faults_;
  HandPlace hand_;
};

}  // namespace hexoderm
