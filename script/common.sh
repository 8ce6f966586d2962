# Sourced by the scripts beside it: they work from any folder and stop at the first error.
set -euo pipefail

root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd -P)

say() { printf '%s\n' "$*" >&2; }
fail() {
  say "$(basename -- "$0"): $*"
  exit 1
}

# The comment at the head of the calling script is its help.
help_if_asked() {
  case "${1:-}" in
    -h | --help)
      sed -n '2,/^[^#]/s/^# \{0,1\}//p' "$0"
      exit 0
      ;;
  esac
}

# As many compilers as there are processors, but no more than memory allows: the largest source
# files need about 1 GiB each.
jobs_for_build() {
  local jobs kib
  jobs=$(nproc 2>/dev/null || echo 1)
  kib=$(awk '/^MemAvailable:/ { print $2 }' /proc/meminfo 2>/dev/null || true)
  if [ -n "$kib" ] && [ $((kib / 1048576)) -lt "$jobs" ]; then jobs=$((kib / 1048576)); fi
  if [ "$jobs" -lt 1 ]; then jobs=1; fi
  echo "$jobs"
}

# build_targets PRESET [TARGET...]: configures build/PRESET, then builds the targets, or everything.
build_targets() {
  local preset=$1
  shift
  cd "$root"
  # A build folder from elsewhere, such as a copied checkout, would make CMake stop.
  local cache=build/$preset/CMakeCache.txt
  if [ -f "$cache" ] && ! grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$root" "$cache"; then
    say "build/$preset belongs to another folder; configuring it anew."
    cmake -E rm -rf "build/$preset"
  fi
  local log
  log=$(mktemp)
  if ! cmake --preset "$preset" >"$log" 2>&1; then
    cat "$log" >&2
    rm -f "$log"
    fail "configuring the preset \"$preset\" failed. Presets: $(preset_names)."
  fi
  rm -f "$log"
  cmake --build --preset "$preset" --parallel "$(jobs_for_build)" ${1:+--target "$@"}
}

preset_names() {
  cd "$root" && cmake --list-presets=configure | sed -n 's/^ *"\([^"]*\)".*/\1/p' | paste -sd ' '
}
