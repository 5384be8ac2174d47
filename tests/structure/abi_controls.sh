#!/bin/bash
# Shows that abi.py accepts types that are laid out alike and catches those that are not.
# Usage: abi_controls.sh COMPILER [COMPILER_ARGUMENT...]
set -euo pipefail
check="$(dirname "${BASH_SOURCE[0]}")/abi.py"
compiler="$1"
shift
folder="$(mktemp -d)"
trap 'rm -rf "$folder"' EXIT

write() {
  cat >"$folder/types.h" <<CODE
#pragma once
#include <Eigen/Geometry>
#include <optional>
#include <vector>
namespace hexoderm {
using Vector4d = Eigen::Matrix<double, 4, 1, Eigen::DontAlign>;
struct Open {
  double before = 0;
  struct Inner {
    bool set = false;
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
expect() {
  write "${@:2}"
  if output="$(python3 "$check" "$compiler" "$folder" "${arguments[@]}" 2>&1)"; then output="accepted: $output"; fi
  [[ "$output" == *"$1"* ]] || { echo "Expected \"$1\" of \"${*:2}\", but the check said: $output"; exit 1; }
}
arguments=("$@")

expect "accepted: 5 classes" "" "" ""
expect "with -DEIGEN_DONT_VECTORIZE hexoderm::Open is laid out otherwise" "Eigen::Matrix<double, 6, 6> covariance;" "" ""
expect "with -DEIGEN_DONT_VECTORIZE hexoderm::Closed::Seen is laid out otherwise" "" "Eigen::Vector2d at;" ""
expect "with -DEIGEN_DONT_VECTORIZE hexoderm::Closed is laid out otherwise" "" "" "Eigen::Quaterniond q_;"
expect "a matrix of dynamic size is no public member" "Eigen::VectorXd values;" "" ""
expect "a matrix of dynamic size is no public member" "" "" "std::vector<Eigen::Matrix3Xd> values_;"
