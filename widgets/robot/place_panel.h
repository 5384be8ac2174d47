#pragma once

#include "hexoderm/skin/patch_on_link.h"
#include "widgets/robot/place_words.h"
#include "widgets/tables/joint_table.h"
#include "widgets/verify/verify_section.h"

#include <QStringList>
#include <QWidget>
#include <array>
#include <vector>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QListWidget;
class QPushButton;
class QSpinBox;

namespace hexoderm {

class JointTableView;

/// Work for the step that may take a while.
enum class PlaceWork { Robot, Joints, Links, Places };

/// Everything that the panel shows.
struct PlaceStand {
  struct Choice {
    quint32 id = 0;  ///< of a patch its origin cell, of a pose its ID
    QString text;
    friend bool operator==(const Choice&, const Choice&) = default;
  };
  QString why_not;  ///< why nothing can be placed, one sentence; empty: it can

  bool has_robot = false;
  bool names_robot = false;  ///< the session does, also where its file can't be read
  VerifySentence robot;      ///< which one, and what is doubtful about it
  VerifySentence joints;
  JointSheet sheet;  ///< of the robot's joints in the session's poses

  std::vector<Choice> poses;
  quint32 pose = 0;  ///< in which the robot is drawn
  std::vector<Choice> patches;
  quint32 patch = 0;  ///< that is spoken of

  std::vector<LinkChoice> links;
  QStringList other_links;  ///< of the robot, to be chosen against the evidence, or without any
  QString link;             ///< that the patch is taken to be on; empty: open
  VerifySentence link_says;

  bool has_surface = false;  ///< of that link
  PatchPlacement known;
  QString known_fault;  ///< what was wrong about the last point or distance

  QStringList places;
  int place = -1;  ///< the row of the chosen one; -1: none is, or it is not among them
  bool is_placed = false;
  bool is_drawn = false;  ///< the robot has the patch on it, where it is or could be
  bool can_move = false;  ///< by hand
  VerifySentence place_says;
};

/// The step "Place on the robot": which robot, on which link each patch is, where on the link. The panel asks by its
/// requests and shows what it is given; it is narrow enough for the column of steps.
class PlacePanel : public QWidget {
  Q_OBJECT

 public:
  /// `selection` must outlive the panel: its cell is proposed for known points.
  explicit PlacePanel(Selection* selection, QWidget* parent = nullptr);

  void setStand(const PlaceStand& stand);
  [[nodiscard]] const PlaceStand& stand() const { return stand_; }
  void setRunning(PlaceWork work, bool running);
  [[nodiscard]] bool isRunning(PlaceWork work) const;
  /// A point that was picked in 3D: it goes into the fields, and waits there to be added. Ends picking.
  void proposePoint(const Eigen::Vector3d& x_l);
  /// Moving by keys has ended without this panel.
  void endMoving();

 signals:
  void robotWanted();
  void packageWanted();
  void robotRemoved();
  void jointsWanted();
  void anglesTyped(const std::vector<hexoderm::TypedAngle>& angles);
  /// Why joint angles that were typed are not taken, one sentence.
  void anglesRefused(const QString& why);
  void cancelRequested(hexoderm::PlaceWork work);
  void poseChosen(quint32 pose);
  void patchChosen(quint32 origin);
  void linkChosen(const QString& link);
  void surfaceChosen(bool by_surface);
  void pointAdded(const hexoderm::KnownPoint& point);
  void pointRemoved(int index);
  void distanceAdded(const hexoderm::KnownDistance& distance);
  void distanceRemoved(int index);
  /// The place that the mouse or the keyboard is at; -1: none.
  void placePreviewed(int row);
  void placeChosen(int row);
  void placeRemoved();
  /// The patch is to be moved by keys, or no more: it lies where it is to lie.
  void movingChanged(bool moving);
  void lookWanted();
  void pickingChanged(bool picking);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void buildRobot();
  void buildJoints();
  void buildPatch();
  void buildLink();
  void buildKnown();
  void buildPoint();
  void buildDistance();
  void buildPlaces();
  [[nodiscard]] VerifySection* section(PlaceWork work) const;
  void showSheet();
  void showKnown();
  void refreshControls();

  Selection* selection_;
  PlaceStand stand_;
  VerifySection* robot_;
  VerifySection* joints_;
  VerifySection* patch_;
  VerifySection* link_;
  VerifySection* known_;
  VerifySection* places_;
  QPushButton* choose_robot_;
  QPushButton* package_;
  QPushButton* remove_robot_;
  QPushButton* choose_joints_;
  JointTable* joint_table_;
  JointTableView* joint_view_;
  QComboBox* pose_;
  QComboBox* patch_list_;
  QListWidget* links_;
  QComboBox* other_link_;
  QCheckBox* by_surface_;
  QListWidget* known_list_;
  QPushButton* remove_known_;
  QSpinBox* point_cell_;
  std::array<QDoubleSpinBox*, 3> point_mm_;
  QDoubleSpinBox* point_sigma_mm_;
  QPushButton* pick_;
  QPushButton* add_point_;
  QSpinBox* from_cell_;
  QSpinBox* to_cell_;
  QDoubleSpinBox* distance_mm_;
  QDoubleSpinBox* distance_sigma_mm_;
  QPushButton* add_distance_;
  QListWidget* place_list_;
  QPushButton* remove_place_;
  QPushButton* move_;
  QPushButton* look_;
};

}  // namespace hexoderm
