#pragma once

#include "widgets/patch/patch_view.h"

#include <vtkCamera.h>
#include <vtkCommand.h>
#include <array>

namespace hexoderm {

/// Two views of one skin look at it from the same side: whoever moves the camera of one moves that of the other.
class CameraLink {
 public:
  /// Both views outlive the link. Without OpenGL it does nothing.
  CameraLink(PatchView& a, PatchView& b) : views_{&a, &b} {
    for (std::size_t k = 0; k < 2; ++k) {
      vtkCamera* camera = views_.at(k)->camera();
      if (camera != nullptr)
        observers_.at(k) = camera->AddObserver(vtkCommand::ModifiedEvent, this, &CameraLink::follow);
    }
  }

  ~CameraLink() {
    for (std::size_t k = 0; k < 2; ++k) {
      if (observers_.at(k) != 0) views_.at(k)->camera()->RemoveObserver(observers_.at(k));
    }
  }

  CameraLink(const CameraLink&) = delete;
  CameraLink& operator=(const CameraLink&) = delete;

 private:
  void follow(vtkObject* moved, unsigned long /*event*/, void* /*data*/) {
    if (is_following_) return;
    is_following_ = true;
    PatchView& other = *views_.at(moved == views_[0]->camera() ? 1 : 0);
    auto* from = static_cast<vtkCamera*>(moved);
    vtkCamera* to = other.camera();
    const unsigned long before = to->GetMTime();
    to->SetPosition(from->GetPosition());
    to->SetFocalPoint(from->GetFocalPoint());
    to->SetViewUp(from->GetViewUp());
    to->SetViewAngle(from->GetViewAngle());
    to->SetParallelProjection(from->GetParallelProjection());
    to->SetParallelScale(from->GetParallelScale());
    // A picture of its own, and what depends on its shape (WindowCenter, clipping), stays with each view.
    if (to->GetMTime() != before) other.redraw();
    is_following_ = false;
  }

  std::array<PatchView*, 2> views_;
  std::array<unsigned long, 2> observers_{};
  bool is_following_ = false;  ///< what moves now was moved here
};

}  // namespace hexoderm
