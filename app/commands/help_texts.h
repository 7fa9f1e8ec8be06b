// What stands below the options in the help of each command: examples, remarks and exit codes.
#pragma once

namespace touchstone::app::help {

inline constexpr const char* program = R"(
Examples:
  touchstone report                        tests all engines that were built; then open report/index.html
  touchstone check --subjects bullet.double,fcl.libccd --queries distance --junit junit.xml
  touchstone check --subjects "exec:python3 my_engine.py"     your own engine, over JSON lines (docs/protocol.md)
  touchstone replay report/cases/distance.value.bullet.float.json
  touchstone ask distance scene.json       the exact answer, as a rational number, with its proof
  touchstone help check                    the options of one command

Where a command reads a scene, a case or a mesh, - stands for stdin.

Exit codes:
  0    done; check: every property holds; replay: the case does not fail
  1    check, judge or replay saw a failure; simulate: the engine broke or gave up
  2    bad input or usage
  3    a fault of Touchstone itself; or a full disk, or a closed stdout
  130  interrupted: what was asked until then is written, and says that it is partial (SIGHUP: 129, SIGTERM: 143)
  141  nothing reads stdout any more, as in `touchstone list properties | head -1`)";

inline constexpr const char* report = R"(
Examples:
  touchstone report
  touchstone report --effort standard --out nightly
  touchstone report --subjects "exec:python3 my_engine.py" --subjects reference

A report has a row for each property and subject: how many scenes were asked, how many answers were wrong, and by how
much. Each failing row has a case, the smallest scene that was found to fail; `touchstone replay` asks it again.

Exit codes:
  0    the report is written, also if it contains failures
  2    bad input or usage, or the adapter of a subject exec:... does not pass; nothing was judged
  3    a fault of Touchstone itself; or a full disk, or a closed stdout
  130  interrupted (SIGHUP: 129, SIGTERM: 143); the report is written and says that it is partial)";

inline constexpr const char* merge = R"(
Examples:
  touchstone merge shards                                           the report that one run would have written
  touchstone report --effort standard --shard 1/8 --out shards      before that, on one machine
  touchstone report --effort standard --shard 2/8 --out shards      on another, and so on

The shards of a run have the same options but for --shard and --jobs. What they found is merged in the order of the
scenes, and only then failing scenes are made smaller, so the engines must be here too. The report is the same, byte for
byte, as without shards, but for the times, if the engines repeat themselves.

Exit codes:
  0    the report is written
  2    bad input or usage: a shard is missing, cut off, or of a run with other options
  3    a fault of Touchstone itself; or a full disk, or a closed stdout
  130  interrupted (SIGHUP: 129, SIGTERM: 143); the report is written and says that it is partial)";

inline constexpr const char* check = R"(
Examples:
  touchstone check --subjects bullet.double --queries distance,penetration --seed 7
  touchstone check --properties distance.symmetric --cases 5000 --junit junit.xml
  touchstone check --subjects "exec:my_engine --flag a,b" --subjects inproc:reference
  touchstone check --subjects bullet.double --write-baseline known.json     accepts today's failures
  touchstone check --subjects bullet.double --baseline known.json           fails on what is new, worse or gone

Exit codes:
  0    every property holds, or the subject abstains; with --baseline: the run fails exactly as it says
  1    a property fails; with --baseline: the run departs from it
  2    bad input or usage, or the adapter of a subject exec:... does not pass; nothing was judged
  3    a fault of Touchstone itself; or a full disk, or a closed stdout
  130  interrupted (SIGHUP: 129, SIGTERM: 143); what was asked until then is written)";

inline constexpr const char* replay = R"(
Examples:
  touchstone replay docs/counterexample.json
  touchstone replay report/cases/distance.value.bullet.float.json --subject fcl.libccd
  touchstone replay - --json <case.json
  touchstone replay docs/counterexample.json --trace      also prints what is said to the engine, and what it says

A case file holds a scene, a property, a subject and what was found. The subject is asked again in a new process, and
its answer is compared with the exact truth.

Exit codes:
  0  the subject does not fail
  1  it fails (again)
  2  bad input or usage
  3  a fault of Touchstone itself; or a full disk, or a closed stdout)";

inline constexpr const char* minimise = R"(
Examples:
  touchstone minimise docs/counterexample.json --out smaller.json
  touchstone minimise report/cases/distance.value.bullet.float.json --budget 20000

Exit codes:
  0    the smaller case is written
  1    the case does not fail, so there is nothing to make smaller
  2    bad input or usage
  3    a fault of Touchstone itself; or a full disk, or a closed stdout
  130  interrupted (SIGHUP: 129, SIGTERM: 143); the smallest scene so far that fails is written)";

inline constexpr const char* adapter = R"(
Examples:
  touchstone adapter new --lang python my_engine
  touchstone adapter check "exec:python3 my_engine/my_engine.py"
  touchstone adapter check bullet.double --queries distance,penetration --json
  touchstone adapter domain "exec:python3 my_engine/my_engine.py" --queries distance

new writes a folder with an adapter that answers the distance of two balls, and the library that speaks the protocol
for it. check asks scenes that are solved on paper, allows what any engine's errors explain, and says which typical
mistake an adapter makes: a normal that is reversed, half extents taken for extents, another order of a quaternion.
domain proposes a domain for the card, and says from which power of two to which each property holds as the lengths,
aspects, vertices, mass ratios or speeds of plain scenes change.

Exit codes:
  0  new: the folder is written; check: no fault of the adapter was found
  1  check: the adapter has a fault
  2  bad input or usage; new: the folder exists already
  3  a fault of Touchstone itself; or a full disk, or a closed stdout)";

inline constexpr const char* ask = R"(
Examples:
  touchstone ask distance scene.json
  touchstone ask impulse docs/scenes/impact/painleve.json
  touchstone import part.stl | touchstone ask mass - --json

Bodies 0 and 1 are A and B; if there are more, the answer begins with their names. Numbers are read as the exact
rationals that they are. In the answer "exact" is a rational number, "nearest" is the double next to it, and an
interval [lo, hi] contains the exact value.

Exit codes:
  0  done
  2  bad input or usage
  3  a fault of Touchstone itself; or a full disk, or a closed stdout)";

inline constexpr const char* serve = R"(
Examples:
  touchstone serve <questions.jsonl        one answer a line
  python3 -c 'from touchstone_exact import *; print(exact.distance(sphere(1), sphere(2, p=(5, 0, 0))))'

The messages are those of docs/protocol.md; the result of an answer is what `touchstone ask QUERY SCENE --json` prints.
A bad line is answered with what is wrong in it, and the next one is read. The second example is the client for Python
in adapters/python (docs/how_to/ask_from_python.md), which starts this command itself.

Exit codes:
  0    stdin has ended, or a message said "stop"
  2    bad usage
  3    a fault of Touchstone itself; or a full disk, or a closed stdout
  141  nothing reads stdout any more)";

inline constexpr const char* judge = R"(
Examples:
  touchstone judge scene.json --subjects bullet.double,fcl.libccd
  touchstone judge scene.json --subjects "exec:python3 my_engine.py" --queries distance
  touchstone judge docs/scenes/impact/painleve.json --subjects ode.step --json

Prints for each query the exact truth, and for each subject its answer, and whether each property that applies to the
scene holds: the error beside what is allowed.

Exit codes:
  0  no property fails
  1  a property fails, or a subject breaks
  2  bad input or usage
  3  a fault of Touchstone itself; or a full disk, or a closed stdout)";

inline constexpr const char* compare = R"(
Examples:
  touchstone compare old/report.json new/report.json
  touchstone compare report/report.json report/report.json --subjects bullet.impulse=bullet.impulse_tuned

For each subject that is in both reports, prints the properties that changed: new (fails now, and did not before), worse
or better (by its grade; of equal grades, by how often it fails, if both reports asked the same scenes), fixed,
unanswered and answered.

Exit codes:
  0  nothing is new, worse or unanswered
  1  something is
  2  bad input or usage
  3  a fault of Touchstone itself; or a full disk, or a closed stdout)";

inline constexpr const char* plan = R"(
Examples:
  touchstone plan docs/scenes/broad_phase/swarm.json
  touchstone plan dominoes
  touchstone plan scene.json --json

The broad phase leaves out what a scene does not need: few bodies are compared pair by pair, spheres and boxes need no
search over vertices, and bodies that never move need no memory between frames. The pairs that it finds stay the same.
For a scene with a motion, the command prints the same about the simulation.

Exit codes:
  0  done
  2  bad input or usage
  3  a fault of Touchstone itself; or a full disk, or a closed stdout)";

inline constexpr const char* simulate = R"(
Examples:
  touchstone simulate bouncing_ball
  touchstone simulate docs/scenes/motion/rolling/turntable.json --engine bullet --until 3
  touchstone simulate pool_break --out events.jsonl --replay replay.html
  touchstone simulate pool_break --replay replay.html --beside bullet,ode
  touchstone simulate scene.json --engine "exec:python3 my_engine.py"

The table shows the energy and momentum of all bodies that are not fixed; potential energy is 0 at the world's origin.
For a scene with a known future, the greatest error is printed, and the time up to which it holds. The replay page
loads nothing from the network; three.js must be installed to make it (Debian: libjs-three). With --beside it shows
several engines by one clock, --engine in the middle, and how far the others are from it. Bodies that overlap at the
start are bad input for every engine.

Exit codes:
  0    done
  1    the engine broke or gave up; files and table then end at the last time that is known
  2    bad input or usage, or the engine does not answer this query
  3    a fault of Touchstone itself; or a full disk, or a closed stdout
  130  interrupted (SIGHUP: 129, SIGTERM: 143); files and table then end at the last time that is known)";

inline constexpr const char* import = R"(
Examples:
  touchstone import part.stl --out part.json
  touchstone import part.obj | touchstone ask mass -

Exit codes:
  0  done
  2  bad input or usage
  3  a fault of Touchstone itself; or a full disk, or a closed stdout)";

inline constexpr const char* list = R"(
Examples:
  touchstone list subjects                 the engines that can be tested, and what each of them answers
  touchstone list properties               what is tested
  touchstone list motions                  scenes for plan and simulate whose future is known

Exit codes:
  0  done
  2  bad usage
  3  a fault of Touchstone itself; or a full disk, or a closed stdout)";

inline constexpr const char* soak = R"(
Examples:
  touchstone soak
  touchstone soak --pairs 1000000 --seed 7 --jobs 8

Exit codes:
  0    the three algorithms agree on every pair
  2    bad usage
  3    two algorithms disagree, which is a fault of Touchstone itself; or a full disk, or a closed stdout
  130  interrupted (SIGHUP: 129, SIGTERM: 143))";

inline constexpr const char* fuzz = R"(
Examples:
  touchstone fuzz distance                                       fast, for a minute
  touchstone fuzz penetration --subject bullet.double --time 600 --out bullet
  touchstone fuzz impulse --executions 2000 --seed 7 --json      the same result on every machine
  touchstone fuzz distance --properties distance.value --subject "exec:my_engine"
  touchstone fuzz distance --subject fcl.libccd --enlarge 3000   how wrong can it be?

The first scenes are those of the corpus and of the families that check draws too. Then scenes are mutated: moved until
two bodies touch exactly, aligned, flattened, scaled by powers of two, changed by an ulp, spliced. An execution is one
scene. Of distance, the subject is asked once about each, and a screen proves the truth about this one answer; all
properties are asked where the screen does not call the answer right, where it shows something new, and on one of 64
other scenes. So the laws about several answers are tested on few scenes; the command prints both numbers and both
rates. Of the other queries, each scene is asked under all properties. A scene that shows something new is kept and
mutated further: another part of fast is reached, another kind of scene, a larger error, a smaller margin to a wrong
verdict. Where screen and properties contradict each other, the command says so (exit code 3). A finding is reported
once for each cause, with the smallest scene that was found to show it; `touchstone replay` asks it again. With
--enlarge, the numbers of the scene with the largest error are then searched for a larger one.

A crash of a subject in this process ends the command. Behind the pipe (--subject fast) it is a finding.

Exit codes:
  0    no property fails
  1    findings; each has a case file
  2    bad input or usage, or the adapter of a subject exec:... does not pass
  3    a fault of Touchstone itself; or a full disk, or a closed stdout
  130  interrupted (SIGHUP: 129, SIGTERM: 143); the findings until then are written)";

inline constexpr const char* self_test = R"(
Examples:
  touchstone self-test
  touchstone self-test --queries distance,penetration

A known-answer test of the exact answers. The program contains the test vectors that were published with it (vectors/):
scenes with exact answers, of which vectors/README.md says which are proved by programs that share no code with it. This
build computes them again: compiler, libraries and machine may differ from those on which they were published. check and
report do this first, for the queries that they ask, and judge nothing if an answer differs.

Exit codes:
  0    every answer is as it was published
  2    bad input or usage
  3    an answer differs: this build must not judge; or a full disk, or a closed stdout
  130  interrupted (SIGHUP: 129, SIGTERM: 143))";

inline constexpr const char* vectors = R"(
Examples:
  touchstone vectors vectors --check                             are the published answers those of today?
  touchstone vectors vectors --add report/cases/distance.value.bullet.float.json
  touchstone vectors mine --draw 3 --queries distance,penetration
  touchstone vectors vectors --page vectors.html                 a picture and the answer of each

FOLDER has one file for each query, distance.json and so on. Each scene in it stays, and all else is computed again:
classes, margin, scale, allowances and the exact answer. With --add and --draw more scenes are appended. Equal scenes
are written once. What a file contains, and how to read one without this program: vectors/README.md.

Exit codes:
  0  written; --check: no file differs
  1  --check: a file differs
  2  bad input or usage; nothing is written
  3  a fault of Touchstone itself; or a full disk, or a closed stdout)";

inline constexpr const char* summary = R"(
Examples:
  touchstone summary report/report.json
  touchstone summary report/report.json >>"$GITHUB_STEP_SUMMARY"

The table has a row for each subject and a column for each query: how many of the properties that the subject answers
hold, which share of its answers is wrong, and the worst grade of one.

Exit codes:
  0  done
  2  bad input or usage
  3  a fault of Touchstone itself; or a full disk, or a closed stdout)";

inline constexpr const char* bench = R"(
Examples:
  ./touchstone bench broad_phase                                  everything: several minutes
  ./touchstone bench broad_phase --sizes 1000,10000 --workloads coherent,settled --rounds 9 --out coherent
  ./touchstone bench distance                                     time and error of each engine
  ./touchstone bench first_call                                   every query of fast beside the exact reference
  ./touchstone bench impulse                                      work and precision of ways to compute an impact
  ./touchstone bench pixel                                        time of masks, and overlaps that sampling misses
  ./touchstone bench simulation --workloads bouncing_ball,gas     simulators; scenes: `touchstone list motions`
  ./touchstone bench time_of_impact                               casts of moving hulls, and the error of each

The launcher ./touchstone builds the comparison first; the program touchstone by itself only runs what is built.
The engines run in turn, in slices of CPU time; a figure is the median of the rounds. An engine that cannot finish one
frame within the time limit is left out, and named. The files are a table (.csv and .txt) and a plot (.svg).
`first_call` has no plot: it asks both once and names each row in which fast is slower; a figure is the least of the
rounds.

Exit codes:
  0  done
  2  bad input or usage, or the comparison was not built
  3  a fault of Touchstone itself; or a full disk, or a closed stdout)";

inline constexpr const char* test = R"(
Examples:
  ./touchstone test                        builds and runs the whole test suite
  ./touchstone test -R model               the tests whose names match; all options of ctest may follow
  ./touchstone test --preset asan          under AddressSanitizer and UndefinedBehaviorSanitizer

The launcher ./touchstone at the root of the source tree does this; the program touchstone has no tests in it.

Exit codes:
  0  all tests pass
  2  the program touchstone was asked instead of the launcher
  3  the set-up or the build failed
  8  a test failed)";

inline constexpr const char* package = R"(
Examples:
  ./touchstone package                     with the adapters of all engines that are installed
  ./touchstone --minimal package           the judge and our own subjects, without another engine's library

Builds the program, and prints the paths of a Debian package and a tarball of it. Neither needs a compiler where it is
installed; the tarball may be unpacked anywhere. The launcher ./touchstone at the root of the source tree does this.

Exit codes:
  0  the files are written
  2  the program touchstone was asked instead of the launcher
  3  the set-up or the build failed)";

inline constexpr const char* engines = R"(
Examples:
  ./touchstone engines && ./touchstone report

Installs the engines of adapters/engines with npm, in the versions of its lock file, and prints their names. From then
on they are subjects as those that are built: a report judges them too. It installs Node.js if there is none. The
launcher ./touchstone at the root of the source tree does this.

Exit codes:
  0  the engines are installed
  2  the program touchstone was asked instead of the launcher
  3  the set-up or npm failed)";

inline constexpr const char* mutate = R"(
Examples:
  ./touchstone mutate --sample 200 --seed 1
  ./touchstone mutate --help               all options, and what the table says

A mutant is a copy of the source with one fault in it, made from the syntax tree. Each one is built and tried by check,
with effort quick and then standard, and then by the unit tests of its file. The launcher ./touchstone at the root of
the source tree does this; the program touchstone has no source in it.

Exit codes:
  0    the table is written, whatever survived
  2    bad usage; or the program touchstone was asked instead of the launcher
  3    the set-up or the build failed, or a run on the source without a fault fails
  130  interrupted; the same command goes on where it was)";

inline constexpr const char* help = R"(
Examples:
  touchstone help
  touchstone help check

Exit codes:
  0  done
  2  there is no such command)";

inline constexpr const char* completion = R"(
Examples:
  source <(touchstone completion bash)     in this shell; for all shells, a line of ~/.bashrc
  source <(touchstone completion zsh)      the same for zsh and ~/.zshrc

The script completes commands, options and the names that they take, also for ./touchstone. It holds the subjects that
are built when it is made.

Exit codes:
  0  done
  2  bad usage)";

}  // namespace touchstone::app::help
