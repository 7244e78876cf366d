"""Writes boxes.csv and objects.csv: wheels, crates and shards that drift and turn, as an engine would report them."""
import csv, math, random

random.seed(3)
SHARD = [(-0.5, -0.3), (0.5, -0.3), (0.0, 0.6)]
COLOURS = ["#d62728", "#2ca02c", "#9467bd", "#ff7f0e"]


def extent(kind, angle):
    """Half the size of the box of a turned shape, along x and y."""
    if kind == "wheel":
        return 0.5, 0.5
    corners = SHARD if kind == "shard" else [(x, y) for x in (-0.6, 0.6) for y in (-0.35, 0.35)]
    xs = [x * math.cos(angle) - y * math.sin(angle) for x, y in corners]
    ys = [x * math.sin(angle) + y * math.cos(angle) for x, y in corners]
    return (max(xs) - min(xs)) / 2 + 1e-4, (max(ys) - min(ys)) / 2 + 1e-4


shapes = {
    "wheel": {"shape": "ball", "radius": 0.5},
    "crate": {"shape": "brick", "half_x": 0.6, "half_y": 0.35},
    "shard": {"shape": "polygon", "points": "; ".join(f"{x} {y}" for x, y in SHARD)},
}
kinds = [list(shapes)[k % 3] for k in range(40)]
with open("objects.csv", "w", newline="") as file:
    table = csv.DictWriter(file, ["object", "name", "color", "shape", "radius", "half_x", "half_y", "points"])
    table.writeheader()
    for k, kind in enumerate(kinds):
        table.writerow({"object": k, "name": f"{kind} {k}", "color": COLOURS[k % 4], **shapes[kind]})

starts = [[random.uniform(0, 14), random.uniform(0, 8), *(random.uniform(-0.05, 0.05) for _ in "xy")] for _ in kinds]
with open("boxes.csv", "w", newline="") as file:
    table = csv.writer(file)
    table.writerow(["step", "object", "min_x", "max_x", "min_y", "max_y", "angle"])
    for step in range(1, 81):
        for k, (x, y, along_x, along_y) in enumerate(starts):
            angle = k + 0.03 * step * (1 if k % 2 else -1)
            half_x, half_y = extent(kinds[k], angle)
            x, y = x + along_x * step, y + along_y * step
            table.writerow([step, k, x - half_x, x + half_x, y - half_y, y + half_y, angle])
