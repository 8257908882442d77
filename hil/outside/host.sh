# Sourced by the scenarios: the world outside the board. The simulated Falcon is a process here and the board's USB reaches it through usbredir and xHCI;
# the safety lines are wires that are pulled at here. What the board does is asked of it over its console, a line at a time.
#
#   board_folder  what rig/prepare made            out      folder with what pack made of it
#   bin      programs of this machine              seed     of the board's memory layout
#   console  file that gets all that the board says
set -uo pipefail
room=$(mktemp -d)   # short: the path of a socket has at most 107 characters
falcon=0 machine=0 wires=0 patience=${HIL_PATIENCE:-600}   # seconds for whatever the board is told to do

say() { echo "hil: $*" >>"$console"; }

leave() {
  trap '' INT TERM
  local process
  for process in $wires $machine $falcon; do [ "$process" = 0 ] || kill -9 "$process" 2>/dev/null; done
  wait 2>/dev/null
  cp "$room"/wires.log "$console.wires" 2>/dev/null
  rm -rf "$room"
}
trap leave EXIT
trap 'exit 130' INT TERM

fail() {
  trap '' PIPE   # a board that failed has left
  say "FAILED: $*"
  [ $machine = 0 ] || { patience=60 && printf '%s\n' 'sed "s/^/hil: controller: /" /run/controller.log' 'status' >&$to && hear '^hil: ended' && hear '^hil: ended'; }
  sed 's/^/hil: falcon: /' "$room"/falcon*.log >>"$console"
  exit 1
}

# within SECONDS COMMAND...: waits for the command to succeed.
within() {
  local end=$((SECONDS + $1))
  shift
  until "$@" >/dev/null 2>&1; do
    [ $SECONDS -lt $end ] || return 1
    sleep 0.1
  done
}

# ---- the device ---------------------------------------------------------------------------------------------------------------------

# start_falcon HAND OPTIONS...: torques last longer than a board that is slower than the time here takes to renew them.
start_falcon() {
  "$bin/falcon-sim" --usbredir "$room/falcon" --hold-ms 500 --hand "$@" >>"$room/falcon.log" 2>&1 &
  falcon=$!
  within 10 grep -q ready "$room/falcon.log" || fail "the simulated device did not start"
}

# happened FAULT...: waits until the device says that each, as it was ordered, has happened.
happened() {
  local fault
  for fault in "$@"; do
    within "$patience" grep -qxF "falcon-sim: $fault" "$room/falcon.log" || fail "it did not happen: $fault"
    say "happened: $fault"
  done
}

kill_falcon() {
  kill -9 $falcon && wait $falcon 2>/dev/null
  : >"$room/falcon.log"
}

# ---- the board ----------------------------------------------------------------------------------------------------------------------

# Time there passes by a nanosecond an instruction, and as here where the board has nothing to do: never faster than here, so that the device's answers are not late,
# but slower where the board is busy. So what depends on the world outside is waited for outside, with `eventually`.
start_board() {
  mkfifo "$room/to" "$room/from"
  qemu-system-aarch64 -M virt -cpu cortex-a53 -smp 1 -m 256 -display none -monitor none -serial stdio -no-reboot -nic none \
    -icount shift=0,sleep=on -seed "$seed" -rtc base=2026-01-01,clock=vm -semihosting-config enable=on,userspace=on,target=native \
    -device qemu-xhci,id=xhci -chardev "socket,id=falcon,path=$room/falcon,reconnect=1" -device usb-redir,chardev=falcon,bus=xhci.0 \
    -qmp "unix:$room/qmp,server=on,wait=off" -qtest "unix:$room/qtest,server=on,wait=off" -qtest-log /dev/null \
    -kernel "$board_folder/vmlinuz" -initrd "$out/initramfs.gz" -append "console=ttyAMA0 panic=-1 quiet cryptomgr.notests kpti=0 hil=told" \
    <"$room/to" >"$room/from" 2>"$room/machine.log" &
  machine=$!
  exec {to}>"$room/to" {from}<"$room/from"
  within 10 test -S "$room/qtest" || fail "QEMU did not start: $(cat "$room/machine.log")"
  mkfifo "$room/pull" && exec {pull}<>"$room/pull"
  "$bin/board_wires" "$room/qmp" "$room/qtest" <&$pull >"$room/wires.log" 2>&1 &
  wires=$!
  within 10 grep -q ready "$room/wires.log" || fail "no wires: $(cat "$room/wires.log")"
  hear 'hil: told what to do' || fail "the board did not boot"
}

# hear PATTERN: reads what the board says until a line matches; keeps the line in `heard`.
hear() {
  local end=$((SECONDS + patience))
  while [ $SECONDS -lt $end ] && IFS= read -r -t $((end - SECONDS)) heard <&$from; do
    heard=${heard%$'\r'}
    printf '%s\n' "$heard" >>"$console"
    [[ $heard =~ $1 ]] && return 0
  done
  return 1
}

# board COMMAND...: one line of the board's shell. A command that fails ends the scenario, unless it is asked with `does`.
does() {
  printf '%s\n' "$*" >&$to
  hear '^hil: ended ([0-9]+)$' || fail "the board did not end: $*"
  [ "${BASH_REMATCH[1]}" = 0 ]
}
board() { does "$@" || fail "on the board: $*"; }

# eventually COMMAND...: asks the board until it says yes. A question costs as much as seconds in which the board waits.
eventually() {
  local end=$((SECONDS + patience))
  until does "$@"; do
    [ $SECONDS -lt $end ] || fail "on the board never: $*"
    board sleep 1
  done
}

# A device whose hand presses 3 mm into a ball and stays there, trembling; a board, which is told `first` if there is something; and a controller that has the
# ball: feel OPTIONS_OF_THE_FALCON...
first=""
feel() {
  start_falcon tremor "$@"
  start_board
  [ -z "$first" ] || board "$first"
  board start_recorded
}

# ---- the wires: what the board's pins did, in the order in which they did it -----------------------------------------------------------

press_stop() { echo press >&$pull && within 10 wire stop low || fail "the stop cannot be pressed"; }
release_stop() { echo release >&$pull && within 10 wire stop high || fail "the stop cannot be released"; }

# wire NAME LEVEL: was that its last edge? One that never had an edge is low.
wire() { [ "$(grep "^$1 " "$room/wires.log" | tail -1)" = "$1 $2" ] || { [ "$2" = low ] && ! grep -q "^$1 " "$room/wires.log"; }; }

# Edges of the stop and the enable since `mark`, as one line.
mark() { marked=$(wc -l <"$room/wires.log"); }
edges() { tail -n +$((marked + 1)) "$room/wires.log" | grep -E '^(stop|enable) ' | tr '\n' ',' | sed 's/,$//; s/,/, /g'; }

# Does the heartbeat change while the board lives on for so long? beats SECONDS_OF_THE_BOARD
beats() {
  local before
  before=$(grep -c '^heartbeat ' "$room/wires.log")
  board sleep "$1"
  [ $(($(grep -c '^heartbeat ' "$room/wires.log") - before)) -ge 10 ]
}

# What every scenario ends with: conclude replayed zero, what the recording must show.
conclude() {
  local shown
  board report
  board end_controller
  for shown in "$@"; do board "$shown"; done
  printf 'exit 0\n' >&$to
  while IFS= read -r -t $patience heard <&$from; do printf '%s\n' "${heard%$'\r'}" >>"$console"; done
  wait $machine
  local code=$?
  machine=0
  [ $code = 0 ] || fail "the board ended with $code"
  say done
}
