#!/bin/bash
# Shows that abi.py accepts types that are laid out alike and catches those that are not.
# Usage: abi_controls.sh COMPILER [COMPILER_ARGUMENT...]
set -euo pipefail
check="$(dirname "${BASH_SOURCE[0]}")/abi.py"
compiler="$1"
shift
folder="$(mktemp -d)"
trap 'rm -rf "$folder"' EXIT

# Members of Open, Closed::Seen and Closed.
write() {
  cat >"$folder/types.h" <<CODE
#pragma once
#include <Eigen/Core>
#include <optional>
#include <vector>
namespace hexoderm {
using Vector4d = Eigen::Matrix<double, 4, 1, Eigen::DontAlign>;
inline constexpr int kMost = 10'000;
struct Open {
  double before = 0;
  struct Inner {
    bool set = 10'000 < kMost;  // what stands between two such numbers is no literal
    std::optional<Vector4d> value;
  };
  Inner inner;
  $1
};
class Closed {
 public:
  enum class Kind { A, B };
  struct Seen {
    int a = 0;
    $2
  };
  void take(const Eigen::MatrixXd& argument);
 private:
  struct Unseen {
    int a = 0;
  };
  Unseen unseen_;
  $3
};
template <class T>
struct Generic {
  T value;
};
}  // namespace hexoderm
CODE
}

write "" "" ""
output="$(python3 "$check" "$compiler" "$folder" "$@" 2>&1)" || { echo "Proper types were refused: $output"; exit 1; }
[[ "$output" == *"5 classes" ]] || { echo "Expected 5 classes, but the check said: $output"; exit 1; }

failed=0
write "Eigen::Matrix<double, 6, 6> covariance; Eigen::VectorXd values;" "Eigen::Vector2d at;" \
  "Eigen::Vector4d q_; std::vector<Eigen::Matrix3Xd> lists_;"
if output="$(python3 "$check" "$compiler" "$folder" "$@" 2>&1)"; then
  echo "Accepted: $output"
  exit 1
fi
for expected in "with -DEIGEN_DONT_VECTORIZE hexoderm::Open is laid out otherwise" \
  "with -DEIGEN_DONT_VECTORIZE hexoderm::Closed::Seen is laid out otherwise" \
  "with -DEIGEN_DONT_VECTORIZE hexoderm::Closed is laid out otherwise" \
  "types.h:15: a matrix of dynamic size is no public member" "types.h:30: a matrix of dynamic size is no public member"; do
  [[ "$output" == *"$expected"* ]] || { echo "Not found: $expected; the check said: $output"; failed=1; }
done
exit $failed
