# The board's part of a scenario whose hand is outside: does what the console says, line by line, and answers how each ended. The same functions as on
# the virtual board, and a few of its own.
. /lib/board.sh

# The lines that are pulled at from outside: the board's own chip. Line 3 is its power button.
use_wires() { printf '[lines]\nchip = "gpiochip0"\nstop = 0\nenable = 1\nheartbeat = 2\nlight = 4\n' >>/etc/isotouchd.toml; }

# Does the hand feel a force just now?
is_pressed() { isotouchctl watch --to $control --rate 1000 --seconds 0.02 | awk -F, 'NR > 1 && $2 == "active" && ($9 != 0 || $10 != 0 || $11 != 0) { n++ } END { exit n < 20 }'; }

# Has the driver said so often that the device runs?
times_running() { [ "$(grep -c '^device: running' /run/controller.log)" -ge "$1" ]; }

# A person resumes and feels the ball. Where the hand of a device that was just homed is still on its way through it, that is a fault anew, and the person
# resumes once more.
resumed() {
  isotouchctl resume --to $control >/run/resume.log 2>&1 || fail "resume: $(cat /run/resume.log)"
  sleep 0.5
  is_in active
}

# Only a second without a packet is a fault, not the tenth of one by which a loaded machine may be late: for faults that must pass by themselves.
be_patient() { printf '[limits]\nfault_age_ms = 1000\n' >>/etc/isotouchd.toml; }

# A controller that has a ball, and records from the first tick on.
start_recorded() { start_controller --field /fields/sphere.itf --record /run/all.trace; }

# The recording, once the controller has ended: the core repeats every word.
replayed() {
  isotouchctl replay /fields/sphere.itf /run/all.trace --check --json >/run/replay.log 2>&1 || fail "replay: $(cat /run/replay.log)"
  say "trace all $(sed -nE 's/^ *("(ticks|hash)": .*)/\1/p' /run/replay.log | tr '\n' ' ')"
}

# zero CONDITION: in that recording each input that speaks against forces ended them, as on the virtual board, and one of them showed this; what took longest.
# Which ones there are beside, nobody knows: here a packet may come too late for a tick at any time.
zero() {
  isotouchctl trace stop-latency /run/all.trace >/run/zero.log 2>&1 || fail "forces went on: $(cat /run/zero.log)"
  ticks=$(awk 'NR > 1 { print $3 }' /run/zero.log | sort -n | tail -1)
  awk 'NR > 1 { print "+" $2 "+" }' /run/zero.log | grep -qF "+$1+" || fail "no force ended with '$1': $(cat /run/zero.log)"
  say "to zero $ticks"
}

# touched NAME TICKS: has a recording so many ticks with a force?
touched() {
  forces=$(commands_in "$1" | wc -l)
  say "touched: $forces ticks"
  [ "$forces" -ge "$2" ]
}

report() {
  tell_status
  isotouchctl latency --to $control | sed 's/^/hil: /'
}

# A soft surface: packets may be late by many ticks of a loaded machine, and the hand must still come to rest on it.
printf '[feel]\nstiffness = 0.2\n' >>/etc/isotouchd.toml
stty -echo
say "told what to do"
while read -r command; do
  eval "$command"
  say "ended $?"
done
