#pragma once

#include <Eigen/Core>

class vtkCamera;

namespace hexoderm {

// Functions that move the camera of the 3D scene with the part that is held. Directions are up directions, unit vectors
// in the scene's frame, which is the patch's: the part stays where it is there, and the camera goes round it.

/// Turns the camera about its focal point as the world turns about the part when up goes from one direction to another:
/// by the smallest rotation, so that the part does not spin about gravity. Up is upwards in the picture afterwards, and
/// the camera looks at the part from as far above as before.
void turnCameraWithPart(vtkCamera* camera, const Eigen::Vector3d& from_up, const Eigen::Vector3d& to_up);

/// Up is upwards in the picture, seen a little from above, from about the side it was seen from before.
void standCameraUpright(vtkCamera* camera, const Eigen::Vector3d& up);

/// Turns the camera about up through its focal point: the part seems to turn by `angle_rad`, counter-clockwise seen
/// from above.
void spinPartInPicture(vtkCamera* camera, const Eigen::Vector3d& up, double angle_rad);

/// The direction to the right in the picture, perpendicular to `up`.
Eigen::Vector3d rightInPicture(vtkCamera* camera, const Eigen::Vector3d& up);

}  // namespace hexoderm
