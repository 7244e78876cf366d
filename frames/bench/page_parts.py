"""What the programs that make pages of measurements share: tables in Markdown, and gnuplot."""
import subprocess


def table(heads, lines, names=2):
    """In Markdown; the first `names` columns are words, the others numbers."""
    out = ["| " + " | ".join(heads) + " |", "|" + "|".join("---" if i < names else "---:" for i in range(len(heads))) + "|"]
    return "\n".join(out + ["| " + " | ".join(line) + " |" for line in lines]) + "\n"


def gnuplot(script):
    subprocess.run(["gnuplot"], input=script, text=True, check=True)


def data_block(name, points):
    return f"${name} << EOD\n" + "\n".join(" ".join(map(str, p)) for p in points) + "\nEOD\n"


def work_span_table(cells):
    """Of work_span's cells: the share that the caller executes alone, and what it leaves for threads to gain."""
    def line(cell):
        def gain(threads):
            return f"{1 / (cell['alone'] + (1 - cell['alone']) / threads):.2f}"

        parts = ", ".join(f"{name} {100 * share:.1f}" for name, share in cell["parts"].items() if share >= 0.001)
        return [cell["scene"], f"{cell['dim']}D", f"{cell['work']:.0f}", f"{100 * cell['alone']:.1f}", gain(2), gain(16), parts]

    return table(["scene", "dim", "instructions", "alone, %", "2 threads", "16 threads", "in these functions, %"], map(line, cells))
