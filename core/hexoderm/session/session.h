#pragma once

#include "hexoderm/base/joint_angles.h"
#include "hexoderm/device/ground_truth.h"
#include "hexoderm/device/pose_capture.h"
#include "hexoderm/skin/cell_model.h"
#include "hexoderm/skin/neighbor_list.h"
#include "hexoderm/skin/patch_on_link.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace hexoderm {

/// A pose of a session with what the operator decided about it.
struct SessionPose {
  std::shared_ptr<const PoseCapture> capture;  ///< never null
  bool disabled = false;
  std::string why_disabled{};  ///< the operator's words; empty if none
  JointAngles joint_angles{};  ///< where the joints of the robot stood that wears the skin; empty if not known
};

/// The origin of a session, written into every calibration made of it.
struct SourceDescription {
  Message text;        ///< for people, for example "Simulated x17 on cylinder:r=0.0501, ..."
  std::string file;    ///< name of the file it was read from, without folders; empty if none
  std::string sha256;  ///< hash of that file's bytes; for a session store, the digest of its journal
};

/// A link that the operator set aside, because it is a cable for example: it stays known and is kept out of the
/// solution. Named by its ends, so that it stays set aside when the skin is explored again.
struct MutedLink {
  LinkEnd source;  ///< the smaller (ID, port)
  LinkEnd target;
  std::string why{};  ///< the operator's words; empty if none
  friend bool operator==(const MutedLink&, const MutedLink&) = default;
};

/// Whether the body that wears the skin is seen from outside or lies about it: gravity alone can't tell.
enum class SkinSide {
  Unknown,
  Convex,   ///< on the outside of a body
  Concave,  ///< in a hollow
};

/// Everything a reconstruction is computed from, at one revision. Immutable: the holder of the shared pointer can read
/// it on any thread for any time.
struct SessionSnapshot {
  std::uint64_t revision = 0;
  std::shared_ptr<const CellModel> model;         ///< never null
  std::shared_ptr<const NeighborList> neighbors;  ///< never null
  std::vector<SessionPose> poses;
  SourceDescription source;
  std::shared_ptr<const GroundTruth> truth;  ///< null if not known
  std::vector<MutedLink> muted_links;        ///< in ascending order of their ends
  std::optional<RobotDescription> robot{};   ///< that wears the skin, where it was said
  std::vector<PatchPlacement> placements{};  ///< in ascending order of their origin cells
  SkinSide side = SkinSide::Unknown;
};

/// The session while it is worked on: owned by one thread; every change makes a new revision.
class Session {
 public:
  /// A session without poses. Throws InvalidArgument for a model that CellModel::validate() refuses; what is wrong with
  /// the neighbours, SkinGraph finds.
  Session(CellModel model, NeighborList neighbors, SourceDescription source = {});

  [[nodiscard]] const CellModel& model() const { return *now_.model; }             ///< the kind of its cells
  [[nodiscard]] const NeighborList& neighbors() const { return *now_.neighbors; }  ///< the links that cells report
  /// All poses, in their order, disabled ones too.
  [[nodiscard]] const std::vector<SessionPose>& poses() const { return now_.poses; }
  [[nodiscard]] const SourceDescription& source() const { return now_.source; }  ///< where the session is from
  [[nodiscard]] const std::shared_ptr<const GroundTruth>& truth() const {
    return now_.truth;
  }  ///< null: it is not known
  /// The muted links, in ascending order of their ends.
  [[nodiscard]] const std::vector<MutedLink>& mutedLinks() const { return now_.muted_links; }
  /// Null if the link between these ports, in either order, is not set aside.
  [[nodiscard]] const MutedLink* findMutedLink(LinkEnd a, LinkEnd b) const;
  /// The robot that wears the skin, where it was said.
  [[nodiscard]] const std::optional<RobotDescription>& robot() const { return now_.robot; }
  /// What was decided about the places of patches on the robot, in ascending order of their origin cells.
  [[nodiscard]] const std::vector<PatchPlacement>& placements() const { return now_.placements; }
  /// Null if nothing was decided under this origin cell.
  [[nodiscard]] const PatchPlacement* findPlacement(CellId origin) const;
  [[nodiscard]] std::uint64_t revision() const { return now_.revision; }  ///< counts the changes of the session

  /// The device describes itself again: poses, source and truth stay. Throws as the constructor, and changes nothing
  /// then.
  void setSkin(CellModel model, NeighborList neighbors);
  void setTruth(GroundTruth truth);          ///< of a simulated skin
  void setSource(SourceDescription source);  ///< see source()

  /// The ID a next pose should carry: one more than the largest ever used here.
  [[nodiscard]] PoseId nextPoseId() const;
  /// Appends, or inserts at `index`. Several poses of one ID are possible in a file; they become a finding.
  void addPose(SessionPose pose, std::optional<std::size_t> index = std::nullopt);
  /// Throws InvalidArgument if there is no such index.
  SessionPose removePose(std::size_t index);
  /// `why` is kept while the pose is disabled.
  void setPoseDisabled(std::size_t index, bool disabled, std::string why = {});
  /// Where the joints of the robot stood in a pose; empty: not known. Throws InvalidArgument if there is no such index,
  /// and for positions that JointAngles::validate() refuses.
  void setJointAngles(std::size_t index, JointAngles angles);
  /// Sets the link between two ports, in either order, aside or takes it back; `why` is kept while it is set aside. The
  /// link need not be in the topology. Throws InvalidArgument if both ends are the same port.
  void setLinkMuted(LinkEnd a, LinkEnd b, bool muted, std::string why = {});

  [[nodiscard]] SkinSide side() const { return now_.side; }  ///< on the outside of a body or in a hollow
  void setSide(SkinSide side);                               ///< see side()

  /// Throws InvalidArgument for a description that makes no sense.
  void setRobot(std::optional<RobotDescription> robot);
  /// Takes the place of what was decided under the same origin cell; one that is empty removes it. The cell need not be
  /// an origin, nor in the topology. Throws InvalidArgument for one that makes no sense.
  void setPlacement(PatchPlacement placement);

  /// The session as it is now, for other threads.
  [[nodiscard]] std::shared_ptr<const SessionSnapshot> snapshot() const;

 private:
  SessionSnapshot now_;
  std::uint32_t largest_pose_id_ = 0;
};

}  // namespace hexoderm
