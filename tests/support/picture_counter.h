#pragma once

#include "widgets/patch/scene_widget.h"

#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkNew.h>

namespace hexoderm::test {

/// Counts the pictures that are drawn on a canvas, which has to outlive it.
class PictureCounter {
 public:
  explicit PictureCounter(SceneWidget& canvas) : canvas_(canvas) {
    command_->SetClientData(&count_);
    command_->SetCallback([](vtkObject*, unsigned long, void* count, void*) { ++*static_cast<int*>(count); });
    observer_ = canvas_.renderWindow()->AddObserver(vtkCommand::StartEvent, command_);
  }
  ~PictureCounter() { canvas_.renderWindow()->RemoveObserver(observer_); }
  PictureCounter(const PictureCounter&) = delete;
  PictureCounter& operator=(const PictureCounter&) = delete;
  [[nodiscard]] int count() const { return count_; }

 private:
  SceneWidget& canvas_;
  int count_ = 0;
  vtkNew<vtkCallbackCommand> command_;
  unsigned long observer_ = 0;
};

}  // namespace hexoderm::test
