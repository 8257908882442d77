#!/usr/bin/env bash
# Writes into build/PRESET, one terminal after the other. For scripts that stand in the root of the checkout, by `. hil/lib/build.sh`.

# Runs a command or function that writes into a folder below build: FOLDER COMMAND... What another terminal builds there comes to its end first. The subshell
# holds the lock and the command does not, so nothing that it leaves running can.
locked() (
  lock=build/$1.lock code=0
  mkdir -p "${lock%/*}"
  { exec 9>>"$lock" && flock -n -E 75 9; } || code=$?
  case $code in
    0) ;;
    75) echo "dev: another ./dev builds in build/$1; waiting until it has ended" >&2; flock 9 || exit ;;
    *) echo "dev: $lock cannot be locked; if build/ belongs to another user, remove it, or run this as that user" >&2; exit 1 ;;
  esac
  "${@:2}" 9>&-
)

# The log is shown only where it fails.
configure() {
  cmake --preset "$1" >"build/$1.configure.log" || { cat "build/$1.configure.log"; return 1; }
}

configure_and_build() {
  configure "$1" && cmake --build "build/$1" --target "${@:2}"
}

# Builds targets of one preset: PRESET TARGET...
build_target() { locked "$1" configure_and_build "$@"; }
