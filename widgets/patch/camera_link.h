#pragma once

class vtkCamera;

namespace hexoderm {

class PatchView;

/// Two views of one skin look at it from the same side: whoever moves the camera of one moves that of the other.
class CameraLink {
 public:
  /// Both views outlive the link. Without OpenGL it does nothing.
  CameraLink(PatchView& a, PatchView& b);
  ~CameraLink();
  CameraLink(const CameraLink&) = delete;
  CameraLink& operator=(const CameraLink&) = delete;

 private:
  struct End {
    PatchView* view = nullptr;
    unsigned long observer = 0;
  };
  void onFirst() { follow(first_, second_); }
  void onSecond() { follow(second_, first_); }
  void follow(const End& moved, const End& other);

  End first_;
  End second_;
  bool is_following_ = false;  ///< what moves now was moved here
};

}  // namespace hexoderm
