#pragma once

#include "widgets/robot/robot_scene.h"
#include "widgets/style/dressed_theme.h"

#include <QImage>
#include <QPoint>
#include <QWidget>
#include <memory>
#include <optional>

namespace hexoderm {

class SceneWidget;

/// The robot in 3D with the skin on it, to be turned by the mouse, or by the arrow keys once it has the keyboard. It
/// computes nothing itself; without OpenGL it says so in words and stays empty.
///
/// The patch that the picture calls movable can be moved by hand: the mouse grips and pulls it, and in a mode of its
/// own the keyboard slides and turns it. Where it goes then, the next picture says.
class RobotView : public QWidget {
  Q_OBJECT

 public:
  explicit RobotView(QWidget* parent = nullptr);
  ~RobotView() override;

  /// Without bodies: an empty view with a hint.
  void setPicture(const RobotPicture& picture);
  [[nodiscard]] const RobotPicture& picture() const { return picture_; }
  /// On: the next click on the robot is told by pointPicked().
  void setPicking(bool picking);
  /// On: arrow keys slide the patch and turn the robot no more; the view takes the keyboard.
  void setMoving(bool moving);
  /// Whether anything is drawn at all.
  [[nodiscard]] bool canDraw() const;
  /// Draws at once, instead of in the next turns of the event loop.
  void drawNow();
  /// The scene as drawn; empty without OpenGL.
  [[nodiscard]] QImage screenshot();

 public slots:
  void fit();
  /// The cells with their IDs: of one of the picture's patches, or of all.
  void lookAtSkin(std::optional<std::size_t> patch = std::nullopt);

 signals:
  /// A point of a link's body, in the link's frame.
  void pointPicked(std::size_t link, Eigen::Vector3d x_l);
  /// The movable patch is gripped at this point of its link, and pulled to another; then let go.
  void gripped(Eigen::Vector3d x_l);
  void pulledTo(Eigen::Vector3d x_l);
  void released();
  /// By a key: along the screen, in the link's frame, m; counter-clockwise, rad.
  void slid(Eigen::Vector3d way_l);
  void turned(double angle_rad);
  /// Return: it is to lie where it is. Escape: where it was.
  void laid();
  void leftAlone();

 protected:
  void changeEvent(QEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  void build();
  void dress();
  void requestRender();
  void pickAt(const QPoint& position);
  bool beginPulling(const QPoint& position);
  void pullTo(const QPoint& position);
  bool moveByKey(const QKeyEvent& event);
  void showCursor();

  DressedTheme dressed_{*this};
  RobotPicture picture_;
  bool picking_ = false;
  bool moving_ = false;                ///< by keys
  bool pulling_ = false;               ///< by the mouse
  bool is_built_ = false;              ///< from the first robot on: getting OpenGL ready takes its time
  SceneWidget* canvas_ = nullptr;      ///< null until then, and without OpenGL
  std::unique_ptr<RobotScene> scene_;  ///< likewise
  QPoint pressed_at_;
};

}  // namespace hexoderm
