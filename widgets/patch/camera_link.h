#pragma once

#include "widgets/patch/patch_view.h"

#include <vtkCamera.h>
#include <vtkCommand.h>

namespace hexoderm {

/// Two views of one skin look at it from the same side: whoever moves the camera of one moves that of the other.
class CameraLink {
 public:
  /// Both views outlive the link. Without OpenGL it does nothing.
  CameraLink(PatchView& a, PatchView& b) {
    first_.view = &a;
    second_.view = &b;
    if (a.camera() == nullptr || b.camera() == nullptr) return;
    first_.observer = a.camera()->AddObserver(vtkCommand::ModifiedEvent, this, &CameraLink::onFirst);
    second_.observer = b.camera()->AddObserver(vtkCommand::ModifiedEvent, this, &CameraLink::onSecond);
  }

  ~CameraLink() {
    for (const End& end : {first_, second_}) {
      if (end.observer != 0) end.view->camera()->RemoveObserver(end.observer);
    }
  }

  CameraLink(const CameraLink&) = delete;
  CameraLink& operator=(const CameraLink&) = delete;

 private:
  struct End {
    PatchView* view = nullptr;
    unsigned long observer = 0;
  };
  void onFirst() { follow(first_, second_); }
  void onSecond() { follow(second_, first_); }
  void follow(const End& moved, const End& other) {
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

  End first_;
  End second_;
  bool is_following_ = false;  ///< what moves now was moved here
};

}  // namespace hexoderm
