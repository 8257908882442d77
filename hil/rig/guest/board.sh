# Sourced by the scenarios, which the virtual board's shell runs. Every line they print is part of what must be equal in every run of one seed.

set -u
control=unix:/run/control
lines=/sys/devices/platform/gpio-sim.0/gpiochip1   # there once a scenario has made them
falcon=/sys/devices/platform/vhci_hcd.0

say() { echo "hil: $*"; }

fail() {
  say "FAILED: $*"
  sed 's/^/hil: controller: /' /run/controller.log
  sed 's/^/hil: falcon: /' /run/falcon.log
  exit 1
}

# within SECONDS COMMAND...: waits for the command to succeed.
within() {
  left=$(($1 * 5))
  shift
  until "$@" >/dev/null 2>&1; do
    [ $left -gt 0 ] || return 1
    left=$((left - 1))
    sleep 0.2
  done
}

status() { isotouch status --to $control --json; }

# A value of the status, by its key.
status_of() { status | sed -nE "s/^ *\"$1\": \"?([^\",]*)\"?,?\$/\1/p"; }

is_in() { status | grep -qE "\"state\": \"($1)\""; }

# start_falcon OPTIONS...: plugs the simulated device into the kernel's USB.
start_falcon() {
  falcon-sim --vhci $falcon "$@" >/run/falcon.log 2>&1 &
  falcon_process=$!
  within 10 grep -q ready /run/falcon.log || fail "the simulated device did not start"
}

# start_controller OPTIONS...: with lines it first hears a stop, because taking a line pulls it down, as a broken wire would be
start_controller() {
  isotouchd --config /etc/isotouchd.toml --device usb --control /run/control "$@" >/run/controller.log 2>&1 &
  controller_process=$!
  within 10 test -S /run/control || fail "the controller did not start"
  [ -d $lines ] || return 0
  within 5 is_in fault || fail "an open stop line is not heard"
  release_stop
  sleep 0.1
  resume
}

resume() { isotouch resume --to $control >/run/resume.log 2>&1 || fail "resume: $(cat /run/resume.log)"; }

homed() { within 60 is_in 'idle|ready|active|hold' || fail "the device was not homed"; }

upload() { isotouch upload "/fields/$1.itf" --to $control >/run/upload.log 2>&1 || fail "upload: $(cat /run/upload.log)"; }

# record NAME SECONDS FIELD: records, and wants the core to repeat every word.
record() {
  isotouch record --to $control -o "/run/$1.trace" --seconds "$2" >/run/record.log 2>&1 || fail "record: $(cat /run/record.log)"
  isotouch replay "/fields/$3.itf" "/run/$1.trace" --check --json >/run/replay.log 2>&1 || fail "replay: $(cat /run/replay.log)"
  say "trace $1 $(sed -nE 's/^ *("(ticks|hash)": .*)/\1/p' /run/replay.log | tr '\n' ' ')"
}

# What every scenario ends with: the counts and the delays.
conclude() {
  status | sed 's/^/hil: status: /'
  isotouch latency --to $control | sed 's/^/hil: /'
  kill $controller_process && wait $controller_process
  say "controller ended with $?"
  kill $falcon_process && wait $falcon_process
  tail -1 /run/falcon.log | sed 's/^/hil: /'
  say done
}

# ---- safety lines: the kernel's simulated GPIO chip ---------------------------------------------------------------------------------

# Line 0 stop (in), 1 enable, 2 heartbeat, 3 light (out); appends them to the controller's settings.
make_lines() {
  chip=/sys/kernel/config/gpio-sim/board
  mkdir -p $chip/bank0 && echo 8 >$chip/bank0/num_lines && echo 1 >$chip/live || fail "no simulated lines"
  printf '[lines]\nchip = "gpiochip1"\nstop = 0\nenable = 1\nheartbeat = 2\nlight = 3\n' >>/etc/isotouchd.toml
}

press_stop() { echo pull-down >$lines/sim_gpio0/pull; }
release_stop() { echo pull-up >$lines/sim_gpio0/pull; }
line() { cat $lines/sim_gpio$1/value; }

# Does the heartbeat change within 20 ms?
beats() {
  before=$(line 2)
  for i in 1 2 3 4 5 6 7 8 9 10; do
    [ "$(line 2)" = "$before" ] || return 0
  done
  return 1
}

# Everything until the field is felt.
feel() {
  start_falcon --hand tour "$@"
  start_controller
  homed
  upload hydrant
  within 20 is_in active || fail "the field was not felt"
}

reach() { within 10 is_in "$1" || fail "not $1 but $(status_of state)"; }
