# Shared by in_debian.sh and deb_test.sh: an empty Debian in a folder, and commands in it. All mounts belong to the mount
# namespace of the script that makes it (unshare --mount) and end with it.

declare -A debian_names=([12]=bookworm [13]=trixie)

# make_clean_debian RELEASE FOLDER
make_clean_debian() {
  local name="${debian_names[$1]}" folder="$2" mirror
  . /etc/os-release
  mirror="$(apt-get indextargets --format '$(SITE)' 'Created-By: Packages' "Codename: $VERSION_CODENAME" | head -n 1)"
  rm -rf --one-file-system "$folder"
  debootstrap --variant=minbase "$name" "$folder" "$mirror"
  mount -t proc proc "$folder/proc"
  mount --rbind /dev "$folder/dev"
  cp /etc/resolv.conf "$folder/etc/"
  echo "127.0.0.1 localhost" >"$folder/etc/hosts"  # as Debian's installer does
  echo 'APT::Get::Assume-Yes "true";' >"$folder/etc/apt/apt.conf.d/90nobody-answers"
}
remove_clean_debian() { umount -R "$1/dev" "$1/proc" && rm -rf --one-file-system "$1"; }

# inside FOLDER COMMANDS [ARGUMENT...]: bash runs the commands in that Debian, with nothing of this one's environment.
inside_debian() {
  local folder="$1" commands="$2"
  shift 2
  env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LC_ALL=C.UTF-8 DEBIAN_FRONTEND=noninteractive \
    ${http_proxy:+http_proxy="$http_proxy"} ${CI:+CI="$CI"} \
    chroot "$folder" bash -euo pipefail -c "$commands" bash "$@"
}
