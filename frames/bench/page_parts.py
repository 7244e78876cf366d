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
