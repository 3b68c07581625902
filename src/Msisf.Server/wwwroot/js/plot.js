// A small plot on a canvas: a line over a number, with its ends written beside it.

/**
 * Draws a line.
 * @param points [x, y] of each; @param options {yTexts: [lowest, highest], xTexts: [first, last], range: [least, greatest] of y,
 * marks: x of upright lines, colour}.
 */
export function plot(canvas, points, { yTexts, xTexts, range, marks = [], colour = '#8ec5ff', fill = null }) {
    const ratio = window.devicePixelRatio || 1;
    const [width, height] = [canvas.clientWidth * ratio, canvas.clientHeight * ratio].map(Math.round);
    [canvas.width, canvas.height] = [width, height];
    const pen = canvas.getContext('2d');
    const text = 0.875 * parseFloat(getComputedStyle(document.documentElement).fontSize) * ratio;
    const [top, bottom] = [text * 1.5, height - text * 1.6];
    const [first, last] = [points[0][0], points.at(-1)[0]];
    const x = value => (value - first) / (last - first || 1) * width;
    const y = value => bottom - (value - range[0]) / (range[1] - range[0] || 1) * (bottom - top);
    const curve = () => {
        pen.beginPath();
        points.forEach(([along, value], index) => pen[index ? 'lineTo' : 'moveTo'](x(along), y(value)));
    };
    if (fill) {
        curve();
        pen.lineTo(width, bottom);
        pen.lineTo(0, bottom);
        pen.fillStyle = fill;
        pen.fill();
    }
    curve();
    pen.strokeStyle = colour;
    pen.lineWidth = 1.5 * ratio;
    pen.lineJoin = 'round';
    pen.stroke();
    pen.fillStyle = '#ffffff';
    for (const mark of marks.filter(value => value >= first && value <= last)) {
        pen.fillRect(x(mark), top, ratio, bottom - top);
    }
    pen.fillStyle = '#aab4c6';
    pen.font = `${text}px system-ui, sans-serif`;
    pen.textBaseline = 'alphabetic';
    pen.fillText(yTexts[1], text * 0.4, text * 1.1);
    pen.fillText(xTexts[0], text * 0.4, height - text * 0.4);
    pen.textAlign = 'right';
    pen.fillText(yTexts[0], width - text * 0.4, text * 1.1);
    pen.fillText(xTexts[1], width - text * 0.4, height - text * 0.4);
}
