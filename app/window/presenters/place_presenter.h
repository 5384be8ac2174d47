#pragma once

#include "app/window/presenters/place_by_hand.h"
#include "app/window/presenters/place_decisions.h"
#include "app/window/presenters/place_search.h"
#include "app/window/presenters/place_sentences.h"
#include "app/window/presenters/presenter.h"
#include "app/window/session/place_facts.h"

#include <QString>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace hexoderm {

/// The step "Place on the robot": asks for the robot and its joint angles, has links and places found for what the
/// session holds, and writes the operator's decisions into it. The robot takes the place of the patch in the middle of
/// the window while this step is open.
class PlacePresenter : public Presenter {
  Q_OBJECT

 public:
  PlacePresenter(const WindowParts& parts, Placing& placing);

  /// The session was solved anew.
  void setReconstruction(std::shared_ptr<const Reconstruction> reconstruction);
  void refresh();
  /// A URDF or a table of joint angles that was dropped onto the window; false: it is neither, or nothing can be
  /// placed.
  bool takeFile(const QString& path);

 private:
  void connectPanel();
  void connectWork();
  void connectEdits();
  void askForRobot();
  void askForPackage();
  void askForJoints();
  void pickRobot(const RobotDescription& description);
  void readJoints(const QString& path);
  void setAngles(const std::vector<TypedAngle>& angles);

  void showStand();
  void showRobot();
  void lookAtWhatIsNew(const RobotPicture& drawn);

  [[nodiscard]] QString whyNot() const;
  [[nodiscard]] RobotPicture picture() const;
  void take(const QString& fault);

  Placing& placing_;
  PlaceFacts facts_;
  PlaceFaults faults_;
  PlaceSearch search_;
  PlaceByHand by_hand_;
  PlaceSentences sentences_;
  PlaceDecisions decisions_;
  QString joints_file_;  ///< of the last table that was read
  int open_step_ = -1;   ///< as showRobot() last saw it
  /// The patch, by its origin cell, and the link that the camera went up to last.
  std::optional<std::pair<CellId, std::size_t>> looked_at_;
};

}  // namespace hexoderm
