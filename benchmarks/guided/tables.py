# SPDX-License-Identifier: GPL-3.0-or-later
"""The tables of docs/guided.md, in Markdown."""

from .bench import LARGE
from .cases import CAD, FINAL_GROUPS, GROUPS, SMOOTH, THIN, Case, is_base, title
from .figures import average, drift_of, grading, sharp, volume, worst_against
from .methods import BEST_TAUBIN, LATER_PEER, OWN, WINDOWED_SINC, rivals_of
from .runs import WORK, run

# Clean models, by a word in their names: see tests/support/clean_shapes.h.
CLEAN_KINDS = ("cube", "prism", "cone", "cylinder", "plate", "gear", "thread", "figurine", "head", "strips", "hedron",
               "sphere", "waves", "terraces", "tent")


def number(value, digits):
    return "-" if value is None else f"{value:.{digits}f}"


def row(cells):
    return "| " + " | ".join(cells) + " |\n"


def head(columns):
    return row(columns) + "|---|" + "--:|" * (len(columns) - 1) + "\n"


COLUMNS = ["", "normal error", "sharp", "RMS", "volume, %", "drift", *GROUPS]


def summary_row(name, figures):
    return row([name, number(average(figures, "normal_error_mean"), 3), number(sharp(figures), 2),
                number(average(figures, "distance_rms"), 4), number(volume(figures), 3),
                number(average(figures, "true_tangential_drift"), 4),
                *(number(average(figures, "normal_error_mean", cases), 2) for cases in GROUPS.values())])


def case_table(results, methods):
    text = head(["", "noisy", *methods])
    for case in results["noisy"]:
        errors = {m: results[m][case]["normal_error_mean"] for m in ("noisy", *methods)}
        best = min(errors.values())
        text += row([title(case), *(f"**{e:.2f}**" if e == best else f"{e:.2f}" for e in errors.values())])
    return text


def final_table(bench, cases, methods):
    """Mean normal error on the final set, by kind of noise."""
    text = head(["", *FINAL_GROUPS])
    results = {name: {c: bench.figures(name, c) for c in cases} for name in ("noisy", *methods)}
    results["guided, blend off"] = {c: bench.variant(["blend=0"], c) for c in cases}
    for name, figures in results.items():
        text += row([name, *(number(average(figures, "normal_error_mean", of), 2) for of in FINAL_GROUPS.values())])
    return text


def clean_shapes(bench):
    """The clean models of the tests and all generated shapes, by name."""
    folder = WORK / "clean"
    folder.mkdir(exist_ok=True)
    run(bench.shapes_tool, folder)
    shapes = {path.stem: path for path in sorted(folder.glob("*.ply"))}
    generated = {f"generated {shape.replace('_', ' ')}": bench.clean(Case(shape, 0, "normal"))
                 for shape in dict.fromkeys((*CAD, *THIN, *SMOOTH, "graded_cube"))}
    return {**shapes, **generated}


def clean_table(bench):
    """What the guided method does where there is nothing to do: the worst of each kind."""
    kinds = {}
    for name, path in clean_shapes(bench).items():
        kind = "generated" if name.startswith("generated") else next(k for k in CLEAN_KINDS if k in name)
        report = bench.report(path, WORK / "result.ply")
        edge, volume_before = report["average_edge_length"], report["volume_before"]
        moved = report["rms_displacement"] * (report["moved_vertices"] / report["vertices"]) ** 0.5
        closed = report["border_vertices"] == 0
        kinds.setdefault(kind, []).append((
            moved / edge, report["max_displacement"] / edge, report["flipped_faces"],
            abs(report["volume_after"] / volume_before - 1) * 100 if closed and volume_before else 0))
    text = head(["", "models", "RMS, e", "largest, e", "flipped faces", "volume, %"])
    for kind, found in kinds.items():
        rms, largest, turned, change = (max(column) for column in zip(*found))
        text += row([kind, str(len(found)), f"{rms:.4f}", f"{largest:.3f}", str(turned), f"{change:.4f}"])
    return text


def noise_table(bench, cases):
    """The noise that the guided method sees, in units of the clean mesh's |e|; along the normals."""
    text = head(["", "true", "estimated"])
    for case in cases:
        if case.direction == "given":
            continue
        figures = bench.figures("noisy", case)
        edge = figures["average_edge_length"]
        truth = figures["distance_rms"] if case.slices else case.level / (3 ** 0.5 if case.direction == "any" else 1)
        estimate = bench.report(bench.noisy(case), WORK / "result.ply")["estimated_noise"]
        text += row([title(case), f"{truth:.3f}", f"{estimate / edge:.3f}"])
    return text


def in_short(results, methods):
    """The figures that one asks for first."""
    guided = results["guided"]
    peers = rivals_of(methods)
    error = {p: average(results[p], "normal_error_mean") for p in methods}
    best = min(peers, key=error.get)
    edges = {p: sharp(results[p]) for p in methods}
    best_edges = min(peers, key=edges.get)
    ratio, case = worst_against(results, peers)
    thin = [f["sharp_normal_error_mean"] for c, f in guided.items()
            if c.shape in THIN and c.level <= 0.2 and f["sharp_faces"] > 0]
    noisier = [title(c) for c, f in guided.items() if is_base(c) and f["flipped_faces"] > results["noisy"][c]["flipped_faces"]]
    later = []
    if LATER_PEER in methods:
        later_ratio, later_case = worst_against(results, [LATER_PEER])
        later = [(f"normal error against {LATER_PEER}", f"{100 * error['guided'] / error[LATER_PEER]:.0f} %"),
                 (f"worst case against {LATER_PEER}", f"{later_ratio:.2f} ({title(later_case)})")]
    further = [(f"{group}: worst case against {peer}", f"{worst:.2f} ({title(where)})")
               for group, peer in (("correlated", BEST_TAUBIN), ("real", BEST_TAUBIN), ("voxels", WINDOWED_SINC),
                                   ("slices 3", WINDOWED_SINC), ("slices 6", WINDOWED_SINC))
               if peer in methods and any(map(GROUPS[group], guided))
               for worst, where in [worst_against(results, [peer], GROUPS[group])]]
    rows = [
        (f"normal error against the best peer, {best}", f"{100 * error['guided'] / error[best]:.0f} %"),
        (f"at sharp edges, against {best_edges}", f"{100 * edges['guided'] / edges[best_edges]:.0f} %"),
        ("worst case against the best peer on it", f"{ratio:.2f} ({title(case)})"),
        *later,
        ("sharp edges of the thin plate, noise 0.1 and 0.2, degrees", f"{max(thin):.2f}"),
        ("drift, CAD shapes, noise 0.2 / 0.3, e", f"{drift_of(guided, 0.2):.4f} / {drift_of(guided, 0.3):.4f}"),
        ("cases with more flipped faces than the noisy mesh",
         str(len(noisier)) + (f" ({'; '.join(noisier)})" if noisier else "")),
        ("graded cube against the uniform one, noise 0.1 / 0.2 / 0.3",
         " / ".join(f"{grading(guided, level):.2f}" for level in (0.1, 0.2, 0.3))),
        *further,
    ]
    return head(["", ""]) + "".join(row(r) for r in rows)


def time_table(bench, methods):
    """Processor seconds, least of three runs of our own programs, one of the others; reading and writing included."""
    case = Case("cad_part", 0.2, "normal")
    source = bench.noisy(case, LARGE)
    target = WORK / "result.obj"
    seconds = {}
    for name in methods:
        runs = 3 if name in OWN else 1
        seconds[name] = min(bench.seconds(name, source, target) for _ in range(runs))
    return head(["", *methods]) + row(["seconds", *(f"{seconds[m]:.2f}" for m in methods)])
