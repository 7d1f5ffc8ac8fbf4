#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# The Debian package, made from a build directory and installed in a fresh root
# of Debian 12: an example is written and torn there on two ranks by a user who
# is not root, and the commands are on the PATH.
#
#   tests/packages/test_deb.sh BUILD_DIRECTORY
#
# Downloads some 400 MB of packages; as root, since programs run in the new root.
# Exit status 77, with the reason, where that cannot be tried. The sources of apt
# of this machine are used, and MMDEBSTRAP_OPTIONS are options of mmdebstrap.
set -eu

skip() {
  printf 'skipped: %s\n' "$*"
  exit 77
}

build=$(realpath -- "${1:?the build directory is missing}")
command -v mmdebstrap >/dev/null || skip "there is no mmdebstrap"
command -v dpkg-shlibdeps >/dev/null || skip "there is no dpkg-shlibdeps (dpkg-dev)"
[ "$(id -u)" -eq 0 ] || skip "only root may change into a new root directory"

work=$(mktemp -d)
cleanup() {
  for directory in proc dev; do
    if mountpoint -q "$work/root/$directory"; then umount -l "$work/root/$directory"; fi
  done
  rm -rf --one-file-system -- "$work"
}
trap cleanup EXIT

echo "== Package"
(cd -- "$build" && cpack -G DEB -B "$work/package" >"$work/cpack.log") || {
  cat "$work/cpack.log"
  exit 1
}
package=$(ls "$work"/package/*.deb)
ls -l "$package"

echo "== A fresh Debian 12"
sources=()
for file in /etc/apt/sources.list /etc/apt/sources.list.d/*.list \
  /etc/apt/sources.list.d/*.sources; do
  if [ -s "$file" ]; then sources+=("$file"); fi
done
# What is installed is downloaded while mmdebstrap still has its lists.
# shellcheck disable=SC2016,SC2086 # $1 is the hook's; options are words
mmdebstrap --quiet --variant=minbase ${MMDEBSTRAP_OPTIONS:-} \
  --customize-hook="upload $package /tmp/mixed-cracks.deb" \
  --customize-hook='chroot "$1" apt-get -q install --no-install-recommends --yes \
    /tmp/mixed-cracks.deb' \
  bookworm "$work/root" "${sources[@]}" >"$work/root.log" 2>&1 || {
  tail -20 "$work/root.log"
  grep -q mixed-cracks "$work/root.log" || skip "mmdebstrap cannot make a root here"
  exit 1
}
mkdir -p "$work/root/proc" "$work/root/dev"
mount -t proc proc "$work/root/proc" || skip "mounting is refused"
mount --bind /dev "$work/root/dev" || skip "mounting is refused"

inside() { chroot "$work/root" "$@"; }
inside useradd --create-home tester

echo "== The example"
inside su - tester -c '
  set -e
  export OMPI_MCA_rmaps_base_oversubscribe=1 OMP_NUM_THREADS=1
  mixed-cracks --version
  mixed-cracks --example punctured_strip
  mpirun -n 2 mixed-cracks punctured_strip.prm | tail -4
  mixed-cracks-report results/punctured_strip
  test -s results/punctured_strip/report.html
  grep -q "\"separated\": true" results/punctured_strip/summary.json
  for command in run sweep study identify picture-3d; do
    command -v "mixed-cracks-$command" >/dev/null
  done
  mixed-cracks-sweep plan /usr/share/mixed-cracks/parameters/epdm/notch_heights.sweep |
    tail -3'
echo "== The package works"
