#pragma once

#include "hexoderm/base/ids.h"
#include "hexoderm/skin/neighbor_list.h"

namespace hexoderm {

/// WrongGain is chosen so that the norm of the readings need not give it away: five sigma of 60 mg of offset and 2 % of
/// scale excuse 1 +- 0.32 g.
enum class SkinFault {
  Dead,       ///< reads 0 and noise
  Stuck,      ///< repeats its first reading for ever
  StuckAxis,  ///< one axis does
  DeadAxis,   ///< one axis, drawn from the seed, reads 0 and noise
  Saturated,  ///< amplifies 20 times and ends at its range
  Noisy,      ///< 20 times the noise
  WrongGain,  ///< amplifies 1.25 times, see above
  NoSamples,
  Echo,     ///< sends what its first neighbour sends
  Swapped,  ///< sends what its first neighbour sends, which sends what this cell would: the two cables are swapped
  Yawed,    ///< is mounted turned by 20 degrees about z
  Reglued,  ///< turns by 10 degrees about an axis drawn from the seed before the recording `reglued_before`
};

/// One cell's sensor is broken in a known way.
struct CellFault {
  SkinFault kind{};
  CellId cell;
};

/// What can be wrong with a link.
enum class LinkFaultKind {
  /// Both cells report the link at another of the cell's ports, which is free; drawn from the seed. Only measurements
  /// can tell.
  WrongPort,
  /// The body part has a hinge: in every second recording (the 2nd, 4th ...) the far side is turned by joint_angle_rad,
  /// as one rigid piece, about the line through the link's middle that runs along the surface, perpendicular to the
  /// link. The truth is that of the unbent part.
  Joint,
  /// The cells are no neighbours in the mould: the far side lies elsewhere, turned by 40 to 120 degrees about any axis
  /// and moved by 0.1 m, always alike; drawn from the seed. The truth says where.
  Cable,
};

/// A link that is broken in a known way, named by one of its ends. The far side of a joint or cable is the side without
/// the patch's middle (the cell that was laid first). If other links hold both sides together too, as in a sheet, the
/// far side is everything behind the line through the link's middle and perpendicular to it when the sheet is laid
/// flat, so that this line cuts those links as well. A closed ring has no far side.
struct LinkFault {
  LinkFaultKind kind{};
  LinkEnd at;
};

/// The whole skin is broken in a known way: not a cell, but what all cells are said to be.
enum class WholeSkinFault {
  Identical,     ///< all cells send what the first one sends
  AxesSwapped,   ///< x and y of all accelerometers are swapped
  AxesPermuted,  ///< x, y and z of all accelerometers are y, z and x
  PortsRotated,  ///< all cells number their ports one side on, around the cell (where the model has as many pairs)
  PortOffset,    ///< all cells report every port's number one higher, the last one as the first
  Shuffled,      ///< whose readings are whose is drawn anew in every recording
  Random,        ///< every cell reads 1 g in a direction drawn anew in every recording
};

}  // namespace hexoderm
