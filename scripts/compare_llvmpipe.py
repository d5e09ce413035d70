#!/usr/bin/env python3
"""Times the tiled algorithm against Mesa's llvmpipe: passes of the two in turn, scene by scene.

What disturbs the machine for a while then disturbs both; still, let it be quiet. The peer harness's llvmpipe_bench draws
the same scenes with Mesa. Columns are the median of the passes' medians and the least frame of all, in ms; the ratio is the
median of the ratios of the passes, each of two medians taken one after the other, then their least and their most.

    scripts/compare_llvmpipe.py --harness HARNESS/llvmpipe_bench --models MODELS
    scripts/compare_llvmpipe.py --harness HARNESS/llvmpipe_bench --threads 2 --mode tex --only large
"""
import argparse
import dataclasses
import math
import os
import re
import statistics
import subprocess
import sys
from pathlib import Path

# Our name of a scene, the harness's name.
STRESS_SCENES = [
    ("stress:fill-front-to-back", "fill_f2b"),
    ("stress:fill-back-to-front", "fill_b2f"),
    ("stress:large", "large"),
    ("stress:medium", "medium"),
    ("stress:tiny", "tiny"),
]
MODELS = ["african_head/african_head.obj", "spot.obj", "stanford-bunny.obj", "nefertiti.obj"]

# The harness's mode, and what draws the same with us.
SHADING_OF_MODE = {"gouraud": "gouraud", "tex": "texture", "texlin": "texture", "depth": None}


def resolved(path):
    return Path(path).resolve()


def arguments():
    root = Path(__file__).resolve().parent.parent
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--harness", required=True, type=resolved, help="the peer harness's llvmpipe_bench")
    parser.add_argument("--models", type=Path, help="folder of the models; without it stress scenes only")
    parser.add_argument("--bench", type=resolved, default=root / "build/release/bench/bench_tiled", help="our bench_tiled")
    parser.add_argument("--threads", type=int, default=1, help="threads of both; 1 is the calling thread alone")
    parser.add_argument("--mode", choices=SHADING_OF_MODE, default="gouraud", help="what llvmpipe draws")
    parser.add_argument("--shading", help="what we draw (default: what fits the mode)")
    parser.add_argument("--set", action="append", default=[], metavar="FIELD=VALUE", help="another setting of ours")
    parser.add_argument("--size", default="1920x1080")
    parser.add_argument("--frames", type=int, default=15, help="frames a pass")
    parser.add_argument("--passes", type=int, default=5, help="passes a scene, of each side")
    parser.add_argument("--only", default="", metavar="REGEX", help="scenes whose name matches")
    given = parser.parse_args()
    if given.threads < 1 or given.frames < 1 or given.passes < 1:
        parser.error("--threads, --frames and --passes take a number from 1")
    if not re.fullmatch(r"\d+x\d+", given.size):
        parser.error("--size takes WIDTHxHEIGHT")
    for program in (given.harness, given.bench):
        if not os.access(program, os.X_OK):
            parser.error(f"{program}: no such program")
    return given


def short_name(scene):
    return Path(scene).stem.removeprefix("stress:")


def scenes(given):
    models = [str(given.models / model) for model in MODELS] if given.models else []
    everything = STRESS_SCENES + [(model, model) for model in models]
    return [names for names in everything if re.search(given.only, short_name(names[0]))]


def output(command, **environment):
    """What a program prints; ends this one where that fails."""
    run = subprocess.run(command, env={**os.environ, **environment}, capture_output=True, text=True)
    if run.returncode != 0:
        sys.exit(f"{' '.join(map(str, command))}: {run.stderr.strip() or run.returncode}")
    return run.stdout


def llvmpipe_pass(given, scene):
    """Median and minimum, ms. LP_NUM_THREADS=0 is llvmpipe on the calling thread."""
    text = output(
        [given.harness, scene, *given.size.split("x"), str(given.frames), given.mode, "cull=1"],
        LP_NUM_THREADS=str(given.threads if given.threads > 1 else 0),
    )
    found = re.search(r"median ([\d.]+) ms\s+min ([\d.]+)", text)
    if not found:
        sys.exit(f"{given.harness}: no times in: {text.strip()}")
    return float(found[1]), float(found[2])


def tiled_pass(given, scene):
    """Median and minimum, ms."""
    shading = given.shading or SHADING_OF_MODE[given.mode]
    settings = [f"threads={given.threads}", *given.set]
    settings += [f"shading={shading}"] if shading else []
    settings += ["texture-filter=trilinear"] if given.mode == "texlin" else []
    command = [given.bench, "--frames", str(given.frames), "--size", given.size]
    command += [] if shading else ["--depth-only"]
    for setting in settings:
        command += ["--set", setting]
    columns = output([*command, scene]).splitlines()[-1].split()
    return float(columns[1]), float(columns[3])


@dataclasses.dataclass
class Side:
    """What one renderer took over all passes, ms."""

    median: float  # of the medians of the passes
    least: float  # frame of all


@dataclasses.dataclass
class Comparison:
    """How many times as long llvmpipe takes as tiled."""

    llvmpipe: Side
    tiled: Side
    ratios: list[float]  # pass by pass, ascending

    @property
    def ratio(self):
        return statistics.median(self.ratios)

    @property
    def of_minima(self):
        return self.llvmpipe.least / self.tiled.least


def side_of(passes):
    medians, minima = zip(*passes)
    return Side(statistics.median(medians), min(minima))


def compare(given, ours, theirs):
    """Passes of the two in turn."""
    passes = [(llvmpipe_pass(given, theirs), tiled_pass(given, ours)) for _ in range(given.passes)]
    llvmpipe, tiled = zip(*passes)
    return Comparison(side_of(llvmpipe), side_of(tiled), sorted(a[0] / b[0] for a, b in passes))


def geometric_mean(ratios):
    return math.exp(statistics.fmean(map(math.log, ratios)))


def main():
    given = arguments()
    print(f"{given.mode}, {given.size}, {given.threads} thread(s), {given.passes} passes of {given.frames} frames, ms")
    columns = (("llvmpipe", 9), ("min", 9), ("tiled", 9), ("min", 9), ("ratio", 7), ("least", 6), ("most", 6), ("of min", 7))
    print(f"{'':22} " + " ".join(f"{name:>{width}}" for name, width in columns))
    found = []
    for ours, theirs in scenes(given):
        it = compare(given, ours, theirs)
        found.append(it)
        times = f"{it.llvmpipe.median:9.2f} {it.llvmpipe.least:9.2f} {it.tiled.median:9.3f} {it.tiled.least:9.3f}"
        ratios = f"{it.ratio:7.2f} {it.ratios[0]:6.2f} {it.ratios[-1]:6.2f} {it.of_minima:7.2f}"
        print(f"{short_name(ours):22} {times} {ratios}", flush=True)
    if found:
        means = [geometric_mean(getattr(it, name) for it in found) for name in ("ratio", "of_minima")]
        print(f"{'geometric mean':22} {'':39} {means[0]:7.2f} {'':13} {means[1]:7.2f}")


if __name__ == "__main__":
    main()
