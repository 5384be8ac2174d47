#pragma once

#include "widgets/robot/robot_scene.h"
#include "widgets/style/palette.h"

#include <QImage>
#include <QWidget>
#include <memory>

namespace hexoderm {

/// The robot in 3D with the skin on it, to be turned by the mouse, or by the arrow keys once it has the keyboard. It
/// computes nothing itself; without OpenGL it says so in words and stays empty.
class RobotView : public QWidget {
  Q_OBJECT

 public:
  explicit RobotView(QWidget* parent = nullptr);
  ~RobotView() override;

  /// Without bodies: an empty view with a hint.
  void setPicture(const RobotPicture& picture);
  [[nodiscard]] const RobotPicture& picture() const { return picture_; }
  void setTheme(Theme theme);
  /// On: the next click on the robot is told by pointPicked().
  void setPicking(bool picking);
  /// Whether anything is drawn at all.
  [[nodiscard]] bool canDraw() const;
  /// Draws at once, instead of in the next turns of the event loop.
  void drawNow();
  /// The scene as drawn; empty without OpenGL.
  [[nodiscard]] QImage screenshot();

 public slots:
  void fit();

 signals:
  /// A point of a link's body, in the link's frame.
  void pointPicked(std::size_t link, Eigen::Vector3d x_l);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  struct Parts;
  void build();
  void requestRender();
  void pickAt(const QPoint& position);

  RobotPicture picture_;
  Theme theme_ = Theme::Light;
  bool picking_ = false;
  std::unique_ptr<Parts> parts_;  ///< from the first robot on: getting OpenGL ready takes its time
};

}  // namespace hexoderm
