"""Errors over steps, one panel for each scene, as SVG in the colours of the project's figures."""

import math

# Colours on a light and on a dark ground.
INK = [("#0969a8", "#58b0ee"), ("#c4500c", "#ff9050"), ("#0b7f5c", "#45cfa4"), ("#b0478c", "#ea93cb"), ("#8a6a00", "#e0b33c"), ("#0e7c8b", "#54c8d8")]
TEXT, FAINT, LINE, GROUND = ("#1f2328", "#e6edf3"), ("#59636e", "#9da7b1"), ("#e3e6ea", "#2a3038"), ("#ffffff", "#0d1117")
WIDTH, COLUMNS, PANEL_W, PANEL_H, TOP = 1000, 3, 322, 210, 92
# Axes: step in s, error as the scene says.
LEAST_STEP, MOST_STEP, LEAST, MOST = 1e-4, 2e-2, 1e-12, 1e1


def style():
    names = [("t", TEXT), ("f", FAINT), ("l", LINE), ("g", GROUND), *((f"c{k}", ink) for k, ink in enumerate(INK))]
    light = "".join(f".f{n}{{fill:{c[0]}}}.s{n}{{stroke:{c[0]}}}" for n, c in names)
    dark = "".join(f".f{n}{{fill:{c[1]}}}.s{n}{{stroke:{c[1]}}}" for n, c in names)
    return f"<style>{light}@media(prefers-color-scheme:dark){{{dark}}}</style>"


def family(engine):
    """An engine without its setting, or a tier of polhode."""
    return engine if engine.startswith("polhode") else engine.rsplit(", ", 1)[0]


def stroke(engine, engines):
    """Colour by engine; dashed for the best setting of a peer."""
    colour = list(dict.fromkeys(map(family, engines))).index(family(engine)) % len(INK)
    return colour, ' stroke-dasharray="4 3"' if engine.endswith("best found") else ""


def text(x, y, words, size=11, kind="ff", anchor="start", weight="normal"):
    words = words.replace("&", "&amp;").replace("<", "&lt;")
    return f'<text x="{x:.1f}" y="{y:.1f}" font-size="{size}" font-weight="{weight}" text-anchor="{anchor}" class="{kind}">{words}</text>'


def place(step, error):
    """Of a point in a panel."""
    across = math.log(step / LEAST_STEP) / math.log(MOST_STEP / LEAST_STEP)
    up = math.log(min(max(error, LEAST), MOST) / LEAST) / math.log(MOST / LEAST)
    return 44 + across * (PANEL_W - 60), PANEL_H - 34 - up * (PANEL_H - 66)


def panel(name, runs, engines):
    parts = [text(10, 16, name, 12.5, "ft", weight="bold")]
    for power in range(-12, 1, 3):
        x, y = place(LEAST_STEP, 10.0**power)
        parts.append(f'<path d="M{x:.1f} {y:.1f}H{PANEL_W - 16}" class="sl"/>' + text(x - 4, y + 4, f"1e{power}", 10, anchor="end"))
    for power in (-4, -3, -2):
        x, y = place(10.0**power, LEAST)
        parts.append(text(x, y + 14, f"1e{power}", 10, anchor="middle"))
    for engine, points in runs.items():
        (colour, dash), kept, broken = stroke(engine, engines), [], []
        # A curve is cut where it breaks.
        for step, error in points:
            (kept if error is not None else broken).append((step, error))
        pieces, before = "", True
        for step, error in points:
            if error is not None:
                x, y = place(step, error)
                pieces += f"{'M' if before else 'L'}{x:.1f} {y:.1f}"
            before = error is None
        parts.append(f'<path d="{pieces}" fill="none" class="sc{colour}" stroke-width="1.6"{dash}/>')
        parts += [f'<circle cx="{x:.1f}" cy="{y:.1f}" r="2.2" class="fc{colour}"/>' for x, y in (place(*p) for p in kept)]
        for step, _ in broken:
            x, y = place(step, MOST)
            parts.append(f'<path d="M{x - 3:.1f} {y - 3:.1f}l6 6m0 -6l-6 6" class="sc{colour}"/>')
    return "".join(parts)


def figure(found):
    """Of steps and errors by scene and engine; an error that is none is a run that broke (a cross at the top)."""
    engines = list(dict.fromkeys(engine for runs in found.values() for engine in runs))
    rows = -(-len(found) // COLUMNS)
    height = TOP + rows * PANEL_H
    parts = [
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{WIDTH}" height="{height}" viewBox="0 0 {WIDTH} {height}" role="img" '
        "font-family=\"Helvetica, Arial, 'Liberation Sans', sans-serif\">",
        f'<title>Error over step</title>{style()}<rect width="{WIDTH}" height="{height}" class="fg"/>',
        text(12, 23.6, "Error over step", 16, "ft", weight="bold"),
        text(12, 43, "step, s, across; what the error is of stands in the table; 1e-12 and less at the bottom; dashed: the best setting found; a cross is a run that breaks"),
    ]
    x, y = 12, 64
    for engine in engines:
        if x + 7 * len(engine) + 34 > WIDTH:
            x, y = 12, y + 17
        colour, dash = stroke(engine, engines)
        parts.append(f'<path d="M{x} {y - 4}h20" class="sc{colour}" stroke-width="2"{dash}/>' + text(x + 25, y, engine))
        x += 6.4 * len(engine) + 44
    for k, (name, runs) in enumerate(found.items()):
        at = (12 + k % COLUMNS * (PANEL_W + 4), TOP + k // COLUMNS * PANEL_H)
        parts.append(f'<g transform="translate({at[0]} {at[1]})">{panel(name, runs, engines)}</g>')
    return "\n".join(parts) + "\n</svg>\n"
