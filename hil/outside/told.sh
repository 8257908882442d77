# The board's part of a scenario whose hand is outside: does what the console says, line by line, and answers how each ended. The same functions as on
# the virtual board, and a few of its own.
. /lib/board.sh

# The lines that are pulled at from outside: the board's own chip. Line 3 is its power button.
use_wires() { printf '[lines]\nchip = "gpiochip0"\nstop = 0\nenable = 1\nheartbeat = 2\nlight = 4\n' >>/etc/isotouchd.toml; }

# Does the hand feel a force just now?
is_pressed() { isotouch watch --to $control --rate 1000 --seconds 0.02 | awk -F, 'NR > 1 && $2 == "active" && ($9 != 0 || $10 != 0 || $11 != 0) { n++ } END { exit n < 20 }'; }

# Has it ticked so often?
has_had() { [ "$(status_of ticks)" -ge "$1" ]; }

# How often the driver said that the device runs.
times_running() { [ "$(grep -c '^device: running' /run/controller.log)" = "$1" ]; }

# A controller that has a ball, and records from the first tick on.
start_recorded() { start_controller --field /fields/sphere.itf --record /run/all.trace; }

# The recording, once the controller has ended: the core repeats every word.
replayed() {
  isotouch replay /fields/sphere.itf /run/all.trace --check --json >/run/replay.log 2>&1 || fail "replay: $(cat /run/replay.log)"
  say "trace all $(sed -nE 's/^ *("(ticks|hash)": .*)/\1/p' /run/replay.log | tr '\n' ' ')"
}

# zero: in that recording, the ticks from the first one whose input shows what ended a force (its sample is not fresh, a line is bad, it is late) to the first
# without any force. Of several, the one that was shown longest: here a packet may come too late for a tick at any time. A record: SPEC.md, section 5.
zero() {
  hexdump -v -s 224 -e '96/1 "%u " "\n"' /run/all.trace | awk '
    { shows = $17 != 1
      force = $61 + $62 + $63 + $64 + $65 + $66 > 0
      if (shows && !showed) { first = NR; felt = had; ended = -1 }
      if (shows && felt && !force && ended < 0) ended = NR - first
      if (shows && ended >= 0 && NR - first > longest) { longest = NR - first; ticks = ended }
      showed = shows; had = force
    }
    END { if (ticks == "") exit 1; print "hil: to zero", ticks }' || fail "no force ended"
}

report() {
  status | sed 's/^/hil: status: /'
  isotouch latency --to $control | sed 's/^/hil: /'
}

end_controller() {
  kill $controller_process && wait $controller_process
  say "controller ended with $?"
}

stty -echo
say "told what to do"
while read -r command; do
  eval "$command"
  say "ended $?"
done
