"""Lines, boxes and words of a drawing as SVG text; the same bytes for the same calls."""
import html

INK, GREY, BLUE, ORANGE, GREEN, RED = "#1b1b1b", "#8a8a8a", "#1f5fa8", "#c96a11", "#2b7a3d", "#b3261e"
PALE = {INK: "#f2f2f2", GREY: "#f7f7f7", BLUE: "#e3eefa", ORANGE: "#fdeedd", GREEN: "#e4f3e7", RED: "#fbe4e2"}
LINE_HEIGHT = 17  # px


def number(value):
    return f"{value:.1f}".rstrip("0").rstrip(".").replace("-0", "0") if abs(value) < 0.05 else f"{value:.1f}".rstrip("0").rstrip(".")


class Drawing:
    """x to the right, y down, px."""

    def __init__(self, width, height, title):
        colours = (INK, GREY, BLUE, ORANGE, GREEN, RED)
        self.parts = [
            f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" width="{width}" height="{height}" '
            'font-family="DejaVu Sans, Verdana, sans-serif" font-size="13">',
            f"<title>{html.escape(title)}</title>",
            "<defs>" + "".join(
                f'<marker id="head{index}" viewBox="0 0 10 10" refX="9" refY="5" markerWidth="7" markerHeight="7" orient="auto">'
                f'<path d="M0,0 L10,5 L0,10 z" fill="{colour}"/></marker>' for index, colour in enumerate(colours)) + "</defs>",
            f'<rect width="{width}" height="{height}" fill="white"/>',
        ]
        self.colours = colours

    def path(self, points, colour=INK, width=1.5, dashes=None, fill="none", closed=False, arrow=False):
        text = "M" + " L".join(f"{number(x)},{number(y)}" for x, y in points) + (" Z" if closed else "")
        more = f' stroke-dasharray="{dashes}"' if dashes else ""
        more += f' marker-end="url(#head{self.colours.index(colour)})"' if arrow else ""
        self.parts.append(f'<path d="{text}" fill="{fill}" stroke="{colour}" stroke-width="{width}"{more}/>')

    def arrow(self, *points, colour=INK, width=1.5, dashes=None):
        self.path(points, colour, width, dashes, arrow=True)

    def circle(self, x, y, radius, colour=INK, width=1.5, fill="none"):
        self.parts.append(f'<circle cx="{number(x)}" cy="{number(y)}" r="{number(radius)}" fill="{fill}" stroke="{colour}" stroke-width="{width}"/>')

    def dot(self, x, y, radius=3.0, colour=INK):
        self.circle(x, y, radius, colour, 0, colour)

    def rectangle(self, x, y, width, height, colour=INK, fill="none", line=1.5, corner=0):
        self.parts.append(f'<rect x="{number(x)}" y="{number(y)}" width="{number(width)}" height="{number(height)}" rx="{corner}" '
                          f'fill="{fill}" stroke="{colour}" stroke-width="{line}"/>')

    def text(self, x, y, words, colour=INK, anchor="start", size=13, bold=False):
        """One line of words, or several separated by line breaks; y is the first one's base line."""
        weight = ' font-weight="bold"' if bold else ""
        for index, line in enumerate(words.split("\n")):
            self.parts.append(f'<text x="{number(x)}" y="{number(y + index * LINE_HEIGHT * size / 13)}" fill="{colour}" text-anchor="{anchor}" '
                              f'font-size="{size}"{weight}>{html.escape(line, quote=False)}</text>')

    def box(self, x, y, width, height, title, words="", colour=INK):
        self.rectangle(x, y, width, height, colour, PALE[colour], corner=6)
        lines = words.count("\n") + 1 if words else 0
        top = y + height / 2 + 5 - lines * LINE_HEIGHT / 2
        self.text(x + width / 2, top, title, colour, "middle", bold=True)
        if words:
            self.text(x + width / 2, top + LINE_HEIGHT, words, INK, "middle", 12)

    def save(self, path):
        path.write_text("\n".join([*self.parts, "</svg>"]) + "\n", encoding="utf-8", newline="\n")
