// Contour lines of the heights in the picture, by marching squares.

import { renderPlane } from './server.js';
import { rangeOf } from './layers.js';
import { lengthText, roundBelow } from './text.js';

const $ = id => document.getElementById(id);
const ABOUT = 12; // lines between the lowest and the highest ground

/**
 * The segments of a level in a plane of values: [x, y, x, y] of each, pixels from 1. Pure.
 * @param plane {width, height, values}, NaN where there is no ground.
 */
export function segmentsOf({ width, height, values }, level) {
    const segments = [];
    const cut = (ax, ay, a, bx, by, b) => {
        const part = (level - a) / (b - a);
        return [ax + (bx - ax) * part, ay + (by - ay) * part];
    };
    for (let y = 0; y < height - 1; y++) {
        for (let x = 0; x < width - 1; x++) {
            const at = y * width + x;
            const [a, b, c, d] = [values[at], values[at + 1], values[at + width + 1], values[at + width]];
            if (Number.isNaN(a + b + c + d)) {
                continue;
            }
            const [X, Y] = [x + 1, y + 1];
            const cuts = [];
            if (a < level !== b < level) cuts.push(cut(X, Y, a, X + 1, Y, b));
            if (b < level !== c < level) cuts.push(cut(X + 1, Y, b, X + 1, Y + 1, c));
            if (c < level !== d < level) cuts.push(cut(X + 1, Y + 1, c, X, Y + 1, d));
            if (d < level !== a < level) cuts.push(cut(X, Y + 1, d, X, Y, a));
            for (let i = 0; i + 1 < cuts.length; i += 2) {
                segments.push([...cuts[i], ...cuts[i + 1]]);
            }
        }
    }
    return segments;
}

export class Contours {
    #abort = new AbortController();
    #lines = null;
    #last = null;

    /** @param onReady is called when the lines of a picture are known. */
    constructor(onReady, onProblem) {
        Object.assign(this, { onReady, onProblem });
        $('show-contours').addEventListener('change', () => (this.#last ? this.know(...this.#last) : onReady()));
    }

    /** Finds the lines of the picture at rest. @param small the frame in fewer pixels, @param size of the picture. */
    async know(small, size) {
        this.forget();
        this.#last = [small, size];
        if (!$('show-contours').checked) {
            this.onReady();
            return;
        }
        this.#abort = new AbortController();
        const { signal } = this.#abort;
        try {
            const plane = await renderPlane({ ...small, layers: ['height'], 'layers-precision': 'single' }, signal);
            const range = rangeOf(plane.values);
            if (signal.aborted || !range) {
                return;
            }
            const step = roundBelow(Math.max((range[1] - range[0]) / ABOUT, 0.01));
            const unit = size.width / plane.width;
            const lines = [];
            for (let level = Math.ceil(range[0] / step) * step; level <= range[1]; level += step) {
                lines.push({ level, isThick: Math.round(level / step) % 5 === 0, segments: segmentsOf(plane, level) });
            }
            this.#lines = { lines, unit };
            $('contour-said').textContent = `Contour lines every ${lengthText(step).replace(/\.0+ /, ' ')}`;
            $('contour-said').hidden = false;
            this.onReady();
        } catch (error) {
            if (!signal.aborted) {
                this.onProblem(error.message);
            }
        }
    }

    /** The lines belong to another picture. */
    forget() {
        this.#abort.abort();
        $('contour-said').hidden = true;
        this.#lines = null;
        this.#last = null;
    }

    /** Draws them over the picture. */
    draw(overlay) {
        for (const { level, isThick, segments } of this.#lines?.lines ?? []) {
            const { unit } = this.#lines;
            const place = (x, y) => overlay.of([(x - 0.5) * unit + 0.5, (y - 0.5) * unit + 0.5]);
            overlay.segments(segments.map(([ax, ay, bx, by]) => [...place(ax, ay), ...place(bx, by)]), isThick);
            const middle = segments[Math.floor(segments.length / 2)];
            if (isThick && middle && segments.length > 40) {
                overlay.label(lengthText(level).replace(/\.0+ /, ' '), place(middle[0], middle[1]), '#ffd9a0', 'center');
            }
        }
    }
}
