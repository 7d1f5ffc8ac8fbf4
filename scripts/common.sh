# SPDX-License-Identifier: GPL-2.0-or-later
# shellcheck shell=bash
# What run-example and run-tests share; sourced, not run.

root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd -P)

say() { printf '\n== %s\n' "$*"; }

fail() {
  printf '%s: %s\n' "$(basename -- "$0")" "$*" >&2
  exit 1
}

# Cores this process may use: a container may be granted less than it sees.
usable_cores() {
  local cores quota period granted
  # nproc obeys the number of threads that a rank is to use
  cores=$(env -u OMP_NUM_THREADS -u OMP_THREAD_LIMIT nproc)
  if [ -r /sys/fs/cgroup/cpu.max ]; then
    read -r quota period </sys/fs/cgroup/cpu.max || true
    if [ "${quota:-max}" != max ] && [ "${period:-0}" -gt 0 ]; then
      granted=$(((quota + period - 1) / period))
      if [ "$granted" -lt "$cores" ]; then cores=$granted; fi
    fi
  fi
  echo "$((cores > 0 ? cores : 1))"
}

# Compilers at a time: a file that includes deal.II takes up to 2 GB.
build_jobs() {
  local kilobytes limit jobs cores
  kilobytes=$(awk '/^MemAvailable:/ { print $2 }' /proc/meminfo 2>/dev/null)
  kilobytes=${kilobytes:-2000000}
  if [ -r /sys/fs/cgroup/memory.max ]; then
    read -r limit </sys/fs/cgroup/memory.max || true
    if [ "${limit:-max}" != max ] && [ "$((limit / 1024))" -lt "$kilobytes" ]; then
      kilobytes=$((limit / 1024))
    fi
  fi
  cores=$(usable_cores)
  jobs=$((kilobytes / 2000000))
  if [ "$jobs" -gt "$cores" ]; then jobs=$cores; fi
  echo "$((jobs > 0 ? jobs : 1))"
}

# Open MPI refuses root and more ranks than cores unless told; in a container
# root is the usual user. Ranks must not be bound to cores, since several runs
# at a time would share the first ones. One thread per rank.
prepare_mpi() {
  export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
  export OMPI_MCA_rmaps_base_oversubscribe=1
  export OMPI_MCA_hwloc_base_binding_policy=none
  export OMPI_MCA_btl_vader_single_copy_mechanism=none
  export OMP_NUM_THREADS=1 OPENBLAS_NUM_THREADS=1 DEAL_II_NUM_THREADS=1
}

# run_stoppably COMMAND...: signals to this script go to the command, and the script
# goes on when that has ended; the exit status is the command's. Under bash alone a
# SIGTERM would end the script and leave the command running.
run_stoppably() {
  local pid signal
  set -m # a group of its own, so that Ctrl-C comes once
  "$@" &
  pid=$!
  set +m
  for signal in TERM INT HUP USR1; do
    # shellcheck disable=SC2064
    trap "kill -$signal $pid 2>/dev/null" "$signal"
  done
  # "wait" returns early when a signal comes; asked again it knows how it ended
  while kill -0 "$pid" 2>/dev/null; do
    wait "$pid" || :
  done
  trap - TERM INT HUP USR1
  wait "$pid"
}

# configure_and_build DIRECTORY TYPE [TARGET]
configure_and_build() {
  local directory=$1 type=$2 new=() home=''
  if [ -f "$directory/CMakeCache.txt" ]; then
    home=$(sed -n 's/^CMAKE_HOME_DIRECTORY:INTERNAL=//p' "$directory/CMakeCache.txt")
    if [ "$home" != "$root" ]; then # the checkout has been moved or copied
      rm -rf -- "$directory/CMakeCache.txt" "$directory/CMakeFiles"
      home=''
    fi
  fi
  # A directory that was configured by hand keeps its generator. Ten files of the
  # library in one: built once, they take a quarter of the time.
  if [ -z "$home" ]; then
    new=(-G Ninja -DCMAKE_UNITY_BUILD=ON -DCMAKE_UNITY_BUILD_BATCH_SIZE=10)
  fi
  say "Configuring ($type) in $directory"
  cmake -S "$root" -B "$directory" "${new[@]}" -DCMAKE_BUILD_TYPE="$type" \
    || fail "configuring failed; the messages above say why"
  say "Building with $(build_jobs) compiler(s) at a time"
  cmake --build "$directory" --parallel "$(build_jobs)" ${3:+--target "$3"} \
    || fail "building failed; the messages above say why"
}
