# Sourced by the scenarios, which the virtual board's shell runs. Every line they print is part of what must be equal in every run of one seed.

set -u
control=unix:/run/control
lines=/sys/devices/platform/gpio-sim.0/none   # a scenario may make them
falcon=/sys/devices/platform/vhci_hcd.0

say() { echo "hil: $*"; }

fail() {
  say "FAILED: $*"
  for log in controller falcon; do
    [ ! -f /run/$log.log ] || sed "s/^/hil: $log: /" /run/$log.log
  done
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

# The counts; `run` takes ticks and late ones from here, so every controller that is ended tells them before.
tell_status() { status | sed 's/^/hil: status: /'; }

status() { isotouchctl status --to $control --json; }

# A value of the status, by its key.
status_of() { isotouchctl status --to $control --key "$1"; }

is_in() { status_of state | grep -qxE "$1"; }

# Where the kernel puts a new program in memory: 2, wherever the seed says, for the controller and the device; 0, in one place, for the tools, because
# QEMU translates a program anew in each place where it stands.
places() { echo $1 >/proc/sys/kernel/randomize_va_space; }

# start_falcon OPTIONS...: plugs the simulated device into the kernel's USB.
start_falcon() {
  places 2
  falcon-sim --vhci $falcon "$@" >/run/falcon.log 2>&1 &
  falcon_process=$!
  within 10 grep -q ready /run/falcon.log || fail "the simulated device did not start"
  places 0
}

ticks_come() { [ "$(status_of ticks)" -gt 0 ]; }

# start_controller OPTIONS...: with lines it first hears a stop, because taking a line pulls it down, as a broken wire would be
start_controller() {
  places 2
  isotouchd --config /etc/isotouchd.toml --device usb --control /run/control "$@" >/run/controller.log 2>&1 &
  controller_process=$!
  within 10 test -S /run/control || fail "the controller did not start"
  places 0
  within 5 ticks_come || fail "the controller does not tick"
  ! grep -q '^runs without' /run/controller.log || fail "the controller is refused what makes it real-time"   # said before the first tick
  [ -d $lines ] || return 0
  within 5 is_in fault || fail "an open stop line is not heard"
  release_stop
  sleep 0.1
  resume
}

resume() { isotouchctl resume --to $control >/run/resume.log 2>&1 || fail "resume: $(cat /run/resume.log)"; }

homed() { within 60 is_in 'idle|ready|active|hold' || fail "the device was not homed"; }

# press OPTIONS...: a hand presses 3 mm into a ball and stays there, trembling; all of it is recorded from the first tick on.
press() {
  start_falcon --hand tremor "$@"
  start_controller --field /fields/sphere.itf --record /run/all.trace
  homed
  within 20 is_in active || fail "the field was not felt"
  sleep 1.2   # from the middle of its way in it presses
}

upload() { isotouchctl upload "/fields/$1.itf" --to $control >/run/upload.log 2>&1 || fail "upload: $(cat /run/upload.log)"; }

# repeats NAME FIELD: the core must repeat every word of a recording, with its patches where it has any; tell_trace NAME: its ticks and its hash.
repeats() {
  isotouchctl replay "/fields/$2.itf" "/run/$1.trace" --check --json >/run/replay.log 2>&1 || fail "replay: $(cat /run/replay.log)"
}
tell_trace() { say "trace $1 $(sed -nE 's/^ *("(ticks|hash)": .*)/\1/p' /run/replay.log | tr '\n' ' ')"; }

# record NAME SECONDS FIELD: records, and wants the core to repeat every word.
record() {
  isotouchctl record --to $control -o "/run/$1.trace" --seconds "$2" >/run/record.log 2>&1 || fail "record: $(cat /run/record.log)"
  repeats "$1" "$3"
  tell_trace "$1"
}

# The recording of everything, once the controller has ended: the core must repeat it, and each input that speaks against forces must have ended them.
# zeros FAULT:CONDITION...: what was ordered, in order, and what an input shows of it; see `isotouchctl trace stop-latency`.
zeros() {
  repeats all sphere
  tell_trace all
  isotouchctl trace stop-latency /run/all.trace >/run/zero.log 2>&1 || fail "forces went on: $(cat /run/zero.log)"
  sed -i 1d /run/zero.log
  [ "$(wc -l </run/zero.log)" = $# ] || fail "not $# faults ended forces: $(cat /run/zero.log)"
  while read -r tick condition ticks state; do
    case +$condition+ in
      *+${1#*:}+*) say "zero ${1%:*}: $condition, $state, ticks $ticks" ;;
      *) fail "${1%:*} is not shown by $condition: $(cat /run/zero.log)" ;;
    esac
    shift
  done </run/zero.log
}

# The ticks of a recording with motor commands, one a line.
commands_in() {
  isotouchctl trace show "/run/$1.trace" --csv --columns tick,command_1,command_2,command_3 | awk -F, 'NR > 1 && ($2 != 0 || $3 != 0 || $4 != 0) { print $1 }'
}

# dialogue FIELD: the core repeats the whole recording, and its dialogue is the one that desk and hand had in lockstep.
dialogue() {
  repeats all "$1"
  as_on_desk "$1"
}

# as_on_desk FIELD: the recording has that dialogue.
as_on_desk() {
  said=$(sh /lib/dialogue /run/all.trace 4000) || fail "its dialogue is not known"
  say "trace $1 $said"
  [ "$said" = "$(cat "/fields/$1.dialogue")" ] || fail "on the desk it is $(cat "/fields/$1.dialogue")"
}

# tour FIELD: a cold device is booted, homed by its hand, and the field touched by it.
tour() {
  start_falcon --hand tour
  start_controller --field "/fields/$1.itf" --record /run/all.trace
  homed
  within 20 is_in active || fail "the field was not felt"
  sleep 4
  conclude
  dialogue "$1"
}

# Ends the controller, which must do so in order.
end_controller() {
  kill $controller_process && wait $controller_process
  code=$?
  say "controller ended with $code"
  [ $code != 4 ] || fail "the recording ended before the run: $(sed -n 's/.* ticks recorded; //p' /run/controller.log | tail -1)"
  [ $code = 0 ] || fail "not an orderly end"
}

# Ends the device; each fault that was ordered must have happened.
end_falcon() {
  kill $falcon_process && wait $falcon_process || fail "the simulated device ended with $?"
  [ -f /run/faults ] || return 0
  while read -r fault; do
    grep -qxF "falcon-sim: $fault" /run/falcon.log || fail "it did not happen: $fault"
  done </run/faults
}

# What every scenario ends with: the counts and the delays.
conclude() {
  tell_status
  isotouchctl latency --to $control | sed 's/^/hil: /'
  end_controller
  end_falcon
  tail -1 /run/falcon.log | sed 's/^/hil: /'
  say done
}

# ---- safety lines: the kernel's simulated GPIO chip ---------------------------------------------------------------------------------

# Line 0 stop (in), 1 enable, 2 heartbeat, 3 light (out); appends them to the controller's settings.
make_lines() {
  chip=/sys/kernel/config/gpio-sim/board
  mkdir -p $chip/bank0 && echo 8 >$chip/bank0/num_lines && echo 1 >$chip/live || fail "no simulated lines"
  lines=$(echo /sys/devices/platform/gpio-sim.0/gpiochip*)   # a board has chips of its own, too
  printf '[lines]\nchip = "'"${lines##*/}"'"\nstop = 0\nenable = 1\nheartbeat = 2\nlight = 3\n' >>/etc/isotouchd.toml
}

press_stop() { echo pull-down >$lines/sim_gpio0/pull; }
release_stop() { echo pull-up >$lines/sim_gpio0/pull; }
line() { cat $lines/sim_gpio$1/value; }

# Every change of an output and every edge of the stop from now on, with the kernel's time; `mark WORD` puts what the scenario does among them.
trace_lines() {
  cd /sys/kernel/tracing
  echo mono >trace_clock
  echo 'name == "isotouchd"' >events/irq/irq_handler_entry/filter
  echo 1 >events/irq/irq_handler_entry/enable
  echo 1 >events/gpio/gpio_value/enable
  cd /
}
mark() { echo "$1" >/sys/kernel/tracing/trace_marker; }

# Takes what was traced: /run/edges has "microseconds line level" for each change of an output, "microseconds mark WORD", and "microseconds mark edge" for
# an edge of the stop as the kernel's interrupt took it.
edges() {
  echo 0 >/sys/kernel/tracing/tracing_on
  base=$(cat $lines/../gpio/gpiochip*/base)
  awk -v base="$base" '
    function time(word) { sub(":", "", word); split(word, parts, "."); return parts[1] * 1000000 + ("1" parts[2]) - 1000000 }   # to this awk 012 is octal
    { for (i = 1; i < NF; ++i) {
        if ($i == "tracing_mark_write:") printf "%d mark %s\n", time($(i - 1)), $(i + 1)
        if ($i == "irq_handler_entry:") printf "%d mark edge\n", time($(i - 1))
        if ($i == "gpio_value:") {
          line = $(i + 1) - base
          if (line in level && level[line] != $(i + 3)) printf "%d %d %d\n", time($(i - 1)), line, $(i + 3)
          level[line] = $(i + 3)
        } } }' /sys/kernel/tracing/trace >/run/edges
}

# after MARK LINE LEVEL: microseconds from a mark to the first such change behind it; empty where there is none
after() { awk -v mark="$1" -v line="$2" -v level="$3" '$2 == "mark" && $3 == mark { from = $1 } from && $2 == line && $3 == level { print $1 - from; exit }' /run/edges; }

# beat FROM TO: edges of the heartbeat between two marks, and the shortest and longest time between two of them, in microseconds
beat() {
  awk -v from="$1" -v to="$2" '
    $2 == "mark" { inside = $3 == from ? 1 : $3 == to ? 0 : inside }
    inside && $2 == 2 { if (n++) { gap = $1 - before; if (!least || gap < least) least = gap; if (gap > most) most = gap }; before = $1 }
    END { print n + 0, least + 0, most + 0 }' /run/edges
}

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
