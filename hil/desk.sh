# Sourced by the scripts beside it: a controller and, unless a real device is named, the simulated Falcon, in a folder of their own that goes with the script.
#
#   bin        folder of the programs, set by the script that sources this
#   control    the controller's address, for the host tool

room=$(mktemp -d)   # short: the path of a socket has at most 107 characters
control=unix:$room/control
started=()

# Ends the controller and what was started with it.
end_controller() {
  local process
  for process in "${started[@]}"; do kill "$process" 2>/dev/null && wait "$process" 2>/dev/null || true; done
  started=()
}

leave() {
  end_controller
  rm -rf "$room"
}
trap leave EXIT

fail() {
  echo "$(basename "$0"): $1; the controller said:" >&2
  cat "$room/controller.log" >&2
  exit 1
}

# Waits up to so many seconds for a command to succeed.
within() {
  local end=$((SECONDS + $1))
  shift
  until "$@" >/dev/null 2>&1; do
    [ $SECONDS -lt $end ] || return 1
    sleep 0.1
  done
}

# Is the controller in one of these states, idle|active?
is_in() { "$bin/isotouch" status --to "$control" --json | grep -E "\"state\": \"($1)\"" >/dev/null; }

# A value of the controller's status.
status_of() { "$bin/isotouch" status --to "$control" --json | sed -nE "s/^ *\"$1\": \"?([^\",]*)\"?,?$/\1/p"; }

# start_controller DEVICE OPTIONS...: on usb, usb:SERIAL, or sim: the simulated Falcon with a hand that tours the object. Returns when it is homed.
start_controller() {
  local device=$1 what="$1: pull the grip out as far as it goes, then push it in"
  shift
  if [ "$device" = sim ]; then
    "$bin/falcon-sim" --socket "$room/falcon" --hand tour >"$room/falcon.log" &
    started+=($!)
    within 10 test -S "$room/falcon" || fail "the simulated Falcon did not start"
    device=sim:$room/falcon what="a simulated Falcon, booted with a synthetic image and homed by its hand"
  fi
  "$bin/isotouchd" --device "$device" --control "$room/control" "$@" >"$room/controller.log" 2>&1 &
  started=($! "${started[@]}")   # ended first, so that its last words reach the device
  within 10 test -S "$room/control" || fail "the controller did not start"
  echo "controller    on $what"
  within 60 is_in 'idle|ready|active|hold' || fail "the device was not homed"
}
