#pragma once

#include "hexoderm/base/triangle_mesh.h"
#include "hexoderm/mounting/place/place.h"
#include "hexoderm/solve/result/reconstruction.h"
#include "widgets/style/scene_colors.h"

#include <memory>
#include <optional>
#include <vector>

class vtkRenderWindow;

namespace hexoderm {

/// The body of every link, in its frame; empty where nothing describes it.
using LinkBodies = std::vector<TriangleMesh>;

/// A robot in one pose with skin on it, as it is to be drawn. Cheap to copy.
struct RobotPicture {
  struct Patch {
    std::size_t patch = 0;  ///< index into the reconstruction's
    std::size_t link = 0;   ///< index into `bodies`
    SE3 T_l_o;
    bool is_proposal = false;  ///< nobody has chosen it yet
  };
  /// A way in which a patch can still be moved.
  struct Free {
    Patch of;
    FreeDirection direction;
  };
  struct Point {
    std::size_t link = 0;
    Eigen::Vector3d x_l = Eigen::Vector3d::Zero();
  };

  std::shared_ptr<const LinkBodies> bodies;  ///< null: no robot
  std::vector<SE3> T_w_l;                    ///< of every link
  std::optional<std::size_t> link;           ///< that is spoken of
  std::shared_ptr<const Reconstruction> skin;
  std::vector<Patch> patches;
  std::optional<std::size_t> movable;  ///< of `patches`: the one that can be moved by hand
  std::vector<Free> free;
  std::vector<Point> points;  ///< known ones
};

/// A robot in 3D without Qt: the bodies of its links, the cells of the patches on it with their IDs, arrows along the
/// ways in which they can still be moved, known points. VTK draws it into the render window that it is attached to, and
/// only when that window renders. The base's z points up.
class RobotScene {
 public:
  RobotScene();
  ~RobotScene();

  /// Adds the scene's renderer to the window; once. The scene must outlive the window's last rendering.
  void attachTo(vtkRenderWindow* window);

  /// The camera moves only for another robot.
  void setPicture(RobotPicture picture);
  [[nodiscard]] const RobotPicture& picture() const;
  void setColors(const SceneColors& colors);
  /// Moves the camera until the whole robot is seen.
  void fit();
  /// Turns the camera about what it looks at; to the right, and up.
  void turn(double right_deg, double up_deg);
  /// Above 1: nearer.
  void zoom(double factor);
  /// Moves the camera before the cells, near enough for their IDs to be read: all of them, or those of one of the
  /// picture's patches. It stays where it is while no cells are drawn.
  void lookAtSkin(std::optional<std::size_t> patch = std::nullopt);
  /// Ways to the right and up on the screen, in the frame of a link, m.
  [[nodiscard]] Eigen::Vector3d wayOnScreen(double right_m, double up_m, std::size_t link);

  /// The point of a link's body at a pixel of the window (origin lower left); none beside the robot.
  [[nodiscard]] std::optional<RobotPicture::Point> pick(double x, double y);
  /// Where a patch is gripped.
  struct Grip {
    std::size_t patch = 0;  ///< of the picture's
    Eigen::Vector3d x_l =
        Eigen::Vector3d::Zero();  ///< in the frame of its link: of the link's body below, or of the skin
  };
  /// The patch whose cell is seen at a pixel of the window.
  [[nodiscard]] std::optional<Grip> grip(double x, double y);
  /// How many cells have their IDs beside them at present.
  [[nodiscard]] std::size_t cellsDrawn() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace hexoderm
