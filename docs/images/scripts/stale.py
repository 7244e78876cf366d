"""Pairs of an engine that forgets to refit: every ninth object has its box of the step before: boxes.csv -> pairs.csv."""
import csv
import itertools

steps, fixed = {}, {}
for row in csv.DictReader(open("boxes.csv")):
    box = [float(row[f"{end}_{axis}"]) for axis in "xy" for end in ("min", "max")]
    (fixed if row["fixed"] == "1" else steps.setdefault(int(row["step"]), {}))[int(row["object"])] = box
with open("pairs.csv", "w") as out:
    out.write("step,a,b\n")
    for step, boxes in steps.items():
        before = steps[max(step - 1, 1)]
        seen = {key: before.get(key, box) if key % 9 == 1 else box for key, box in boxes.items()} | fixed
        for (i, a), (j, b) in itertools.combinations(sorted(seen.items()), 2):
            if not {i, j} <= fixed.keys() and a[0] <= b[1] and b[0] <= a[1] and a[2] <= b[3] and b[2] <= a[3]:
                out.write(f"{step},{i},{j}\n")
