# The packages of Debian 12 and 13 that Hexoderm is built from. Sourced by setup.sh; each list names its purpose.

# Library and command line, and what compiling their tests needs.
core_packages=(
  build-essential
  cmake
  ninja-build
  ccache
  libassimp-dev # test oracle; the library does not use it
  libboost-graph-dev
  libceres-dev # test oracle; the library does not use it
  libcli11-dev
  libconsole-bridge-dev # the log of urdfdom
  libeigen3-dev
  libfmt-dev
  libgmock-dev
  libgtest-dev
  liborocos-kdl-dev
  libprotobuf-dev
  libpugixml-dev
  libsqlite3-dev
  libssl-dev
  libsuitesparse-dev # an elimination order; benchmarks compare with its factor
  liburdfdom-dev
  libzip-dev
  pkg-config # another program is built with it, in a test
  nlohmann-json3-dev
  protobuf-compiler
  python3 # kill tests and an example sender
  pybind11-dev # the Python module, as are the next two
  python3-dev
  python3-numpy
  zlib1g-dev # named in the CMake files of libassimp-dev, which does not bring it
)

# Only for the tests: other programs that read what Hexoderm writes, and rules that its pages and desktop files follow.
test_packages=(
  appstream # holds what desktops are told of the window to their rules, as do the next three
  desktop-file-utils
  libglib2.0-bin
  shared-mime-info
  libmujoco-dev # reads exports back, as do the next two
  liburdfdom-tools
  python3-yaml
  dbus-daemon # a session bus for the test of the desktop's theme
  doxygen # all of the library's reference is documented
  gcc-arm-none-eabi # the example firmware of a skin, and a board to run it on
  qemu-system-arm
  mypy # holds the Python module's types to the module
  python3-jsonschema # holds files to the schemas of their formats
  python3-matplotlib # the picture at the end of an example
)
# Debian 13 has no libsdformat; without it a test is left out.
[ "$(. /etc/os-release && echo "${VERSION_ID:-}")" != 12 ] || test_packages+=(libsdformat-dev)

# hexoderm-ros and its tests: ROS 1 with its master and bags.
ros_packages=(
  python3-geometry-msgs
  python3-rosbag
  python3-sensor-msgs
  python3-tf2-ros
  ros-core
)

# The window and its tests. VTK's CMake files ask for everything VTK was built with; its packages bring all of that.
gui_packages=(
  libqt5svg5-dev
  libqwt-qt5-dev
  libqt5texttospeech5-dev # instructions that are spoken; by speech-dispatcher, where the operator's system has it
  qtmultimedia5-dev
  qtspeech5-speechd-plugin
  qttools5-dev
  qttools5-dev-tools
  qttranslations5-l10n # Qt's own texts in German, used where they are
  libvtk9-dev
  libvtk9-qt-dev
  qtbase5-dev
  fonts-dejavu-core
  fonts-inter
  libgl1-mesa-dri
  xauth
  xvfb
)

# What the presets asan and tsan are compiled with: clang is quicker at it than g++.
sanitizer_packages=(
  clang
  libclang-rt-dev
)

# Only for working on Hexoderm: the presets tidy and fuzz, the formatting test and the benchmarks.
developer_packages=(
  libbenchmark-dev # tests/benchmarks
  clang-format
  clang-tidy
)

# Only for making Debian packages and trying them: deb.sh and deb_test.sh.
debian_packages=(
  debootstrap
  doxygen # the reference in libhexoderm-dev
  dpkg-dev
  file
  git # the commit that the programs name, and its date
  lintian
)
