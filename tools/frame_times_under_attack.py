#!/usr/bin/env python3
"""Frame times of a paced game whose ports are attacked, against the same game in peace, in turns.

    tools/frame_times_under_attack.py [--turns 5] [--seconds 6] [KIND...]

Prints for each kind of hostile client (tests/player_api/hostile_client.py) the median, over turns, of the ratio of the
frames' median times, and of their 99.9 percentiles.
"""
import argparse
import json
import statistics
import subprocess
import tempfile

KINDS = ["silent", "never_reads", "one_byte_a_second", "four_gibibytes", "random_bytes", "half_frames", "nan", "flood",
         "reconnects", "stopped"]
PROGRAM = "build/release/murosimf"


def play(seconds, kind):
    """The frame times of one game, attacked by clients of this kind; of none: in peace."""
    control = 'robots.%s.control={program="player_api", port=%d}'
    with tempfile.TemporaryDirectory() as out:
        game = subprocess.Popen(
            [PROGRAM, "run", "scenarios/game_4v4.toml", "--out", out, "--set", "simulation.pace=1",
             "--set", "simulation.duration=%g" % seconds, "--set", "simulation.control_period=0.008",
             "--set", "robots.all.level=full", "--set", "robots.all.cameras.head.module=none",
             "--set", "robots.all.cameras.chest.module=none", "--set", "output.pictures=false",
             "--set", control % ("red.1", 17001), "--set", control % ("blue.2", 17002)],
            stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        attackers = [subprocess.Popen(["python3", "tests/player_api/hostile_client.py", kind, str(port), str(seconds)])
                     for port in (17001, 17002) if kind]
        game.wait()
        for attacker in attackers:
            attacker.kill()
            attacker.wait()
        with open(out + "/report.json") as file:
            return json.load(file)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("kinds", nargs="*", metavar="KIND", help=" ".join(KINDS))
    parser.add_argument("--turns", type=int, default=5)
    parser.add_argument("--seconds", type=float, default=6)
    arguments = parser.parse_args()
    print("kind                 median   99.9 %   connections  peace [us]")
    for kind in arguments.kinds or KINDS:
        medians, tails, peace, connections = [], [], [], 0
        for _ in range(arguments.turns):
            calm, attacked = play(arguments.seconds, None), play(arguments.seconds, kind)
            medians.append(attacked["frame_seconds"]["median"] / calm["frame_seconds"]["median"])
            tails.append(attacked["frame_seconds"]["p999"] / calm["frame_seconds"]["p999"])
            peace.append(calm["frame_seconds"]["median"] * 1e6)
            connections += sum(p["connections"] for p in attacked["control"]["programs"])
        print("%-20s %.3f    %.3f    %-11d  %.1f" % (kind, statistics.median(medians), statistics.median(tails),
                                                 connections, statistics.median(peace)), flush=True)


if __name__ == "__main__":
    main()
