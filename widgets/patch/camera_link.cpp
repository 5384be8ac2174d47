#include "widgets/patch/camera_link.h"

#include "widgets/patch/patch_view.h"

#include <vtkCamera.h>
#include <vtkCommand.h>

namespace hexoderm {

CameraLink::CameraLink(PatchView& a, PatchView& b) {
  first_.view = &a;
  second_.view = &b;
  if (a.camera() == nullptr || b.camera() == nullptr) return;
  first_.observer = a.camera()->AddObserver(vtkCommand::ModifiedEvent, this, &CameraLink::onFirst);
  second_.observer = b.camera()->AddObserver(vtkCommand::ModifiedEvent, this, &CameraLink::onSecond);
}

CameraLink::~CameraLink() {
  for (const End& end : {first_, second_}) {
    if (end.observer != 0) end.view->camera()->RemoveObserver(end.observer);
  }
}

void CameraLink::follow(const End& moved, const End& other) {
  if (is_following_) return;
  is_following_ = true;
  vtkCamera* from = moved.view->camera();
  vtkCamera* to = other.view->camera();
  const unsigned long before = to->GetMTime();
  to->SetPosition(from->GetPosition());
  to->SetFocalPoint(from->GetFocalPoint());
  to->SetViewUp(from->GetViewUp());
  to->SetViewAngle(from->GetViewAngle());
  to->SetParallelProjection(from->GetParallelProjection());
  to->SetParallelScale(from->GetParallelScale());
  // A picture of its own, and what depends on its shape (WindowCenter, clipping), stays with each view.
  if (to->GetMTime() != before) other.view->redraw();
  is_following_ = false;
}

}  // namespace hexoderm
