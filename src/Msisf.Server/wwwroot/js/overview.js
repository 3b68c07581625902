// The map of the whole Moon with the footprint of the picture: relief as the server has it, and where the Sun is up.

import {
    cameraOf, circleAround, limbAngle, meetSphere, placeOf, pointAt, project, rayThrough, scale, sunAt, REFERENCE_RADIUS,
} from './geometry.js';
import { readGround } from './server.js';

const $ = id => document.getElementById(id);
const [COLUMNS, ROWS] = [144, 72];
const LIT_EVERY = 200; // ms
const ROOM = 12; // px of the page around a pin
const PLACES = ['below', 'above', 'beside']; // in the order in which they are tried

/** Latitude and longitude of a cell's middle; the map's middle is longitude 0. */
const placeAt = (column, row) => [90 - (row + 0.5) * 180 / ROWS, (column + 0.5) * 360 / COLUMNS - 180];

/** The places at the border of the picture; the limb where it is in the picture. Pure. */
export function footprint(view, size, perSide = 24) {
    const camera = cameraOf(view);
    const lens = { ...size, fov: view.fov };
    const corners = [[0.5, 0.5], [size.width + 0.5, 0.5], [size.width + 0.5, size.height + 0.5], [0.5, size.height + 0.5]];
    const places = [];
    for (const [index, [x, y]] of corners.entries()) {
        const [toX, toY] = corners[(index + 1) % 4];
        for (let step = 0; step < perSide; step++) {
            const part = step / perSide;
            const point = meetSphere(camera.position, rayThrough(camera, lens, [x + (toX - x) * part, y + (toY - y) * part]));
            if (point) {
                places.push(placeOf(point));
            }
        }
    }
    const isInside = pixel => pixel && pixel.every((number, axis) => number > 0.5 && number < [size.width, size.height][axis] + 0.5);
    const limb = limbAngle(camera);
    const round = limb === null ? [] : circleAround(camera.position, limb, 180).map(direction => scale(direction, REFERENCE_RADIUS));
    return [...places, ...round.filter(point => isInside(project(camera, lens, point))).map(placeOf)];
}

export class Overview {
    #relief = null;
    #isAsked = false;
    #lit = null;

    constructor(state) {
        this.state = state;
        this.canvas = $('overview');
        this.canvas.addEventListener('click', event => {
            const box = this.canvas.getBoundingClientRect();
            state.look({
                latitude: 90 - (event.clientY - box.top) / box.height * 180,
                longitude: (event.clientX - box.left) / box.width * 360 - 180,
            });
        });
        $('show-overview').addEventListener('change', () => this.#switch());
        this.#switch();
    }

    #switch() {
        this.canvas.hidden = !$('show-overview').checked;
    }

    /** Takes the first place that hides none of some points of the page; without one the map is not shown. */
    avoid(points) {
        const isFree = () => {
            const { left, top, right, bottom } = this.canvas.getBoundingClientRect();
            return points.every(([x, y]) => x < left - ROOM || x > right + ROOM || y < top - ROOM || y > bottom + ROOM);
        };
        for (const place of PLACES) {
            $('corner').dataset.place = place;
            if (isFree()) {
                return;
            }
        }
        $('corner').dataset.place = 'nowhere';
    }

    /** Asks for the relief, once, when the first picture is there. */
    async know(frame) {
        if (this.#isAsked) {
            return;
        }
        this.#isAsked = true;
        const points = Array.from({ length: COLUMNS * ROWS }, (_, i) => placeAt(i % COLUMNS, Math.floor(i / COLUMNS)));
        try {
            this.#relief = shaded(await readGround({ ...frame, model: undefined, res: undefined, width: 16, height: 16 }, points));
            this.draw(this.sun);
        } catch {
            this.#isAsked = false; // the next picture at rest asks again
        }
    }

    /** Draws the map for the state and the Sun of its time. */
    draw(sunPosition) {
        this.sun = sunPosition;
        if (this.canvas.hidden || this.canvas.clientWidth === 0) {
            return;
        }
        const ratio = window.devicePixelRatio || 1;
        [this.canvas.width, this.canvas.height] = [this.canvas.clientWidth, this.canvas.clientHeight].map(side => Math.round(side * ratio));
        const { width, height } = this.canvas;
        const pen = this.canvas.getContext('2d');
        pen.drawImage(this.#cellsUnder(sunPosition), 0, 0, width, height);
        this.#drawFootprint(pen, width, height, ratio);
    }

    /** The relief by day and night; drawn anew when the Sun has moved on, at most some times a second. */
    #cellsUnder(sunPosition) {
        const now = performance.now();
        const isSame = this.#lit?.relief === this.#relief && this.#lit.sunPosition === sunPosition;
        if (this.#lit && (isSame || (this.#lit.relief === this.#relief && now - this.#lit.time < LIT_EVERY))) {
            return this.#lit.cells;
        }
        const cells = Object.assign(document.createElement('canvas'), { width: COLUMNS, height: ROWS });
        const pixels = new ImageData(COLUMNS, ROWS);
        for (let i = 0; i < COLUMNS * ROWS; i++) {
            const [latitude, longitude] = placeAt(i % COLUMNS, Math.floor(i / COLUMNS));
            const isDay = !sunPosition || sunAt(pointAt(latitude, longitude), sunPosition).elevation > 0;
            const level = (this.#relief?.[i] ?? 110) * (isDay ? 1 : 0.4);
            pixels.data.set([level, level, level * (isDay ? 1 : 1.25), 255], 4 * i);
        }
        cells.getContext('2d').putImageData(pixels, 0, 0);
        this.#lit = { cells, sunPosition, relief: this.#relief, time: now };
        return cells;
    }

    #drawFootprint(pen, width, height, ratio) {
        const { view, size } = this.state;
        const places = footprint(view, size);
        const x = longitude => ((longitude + 180) % 360 + 360) % 360 / 360 * width;
        const y = latitude => (90 - latitude) / 180 * height;
        pen.fillStyle = '#8ec5ff';
        for (const { latitude, longitude } of places) {
            pen.fillRect(x(longitude) - ratio, y(latitude) - ratio, 2 * ratio, 2 * ratio);
        }
        pen.strokeStyle = '#ffffff';
        pen.lineWidth = 1.5 * ratio;
        pen.beginPath();
        pen.arc(x(view.longitude), y(view.latitude), 3 * ratio, 0, 2 * Math.PI);
        pen.stroke();
    }
}

/** Grey levels of heights, by the height and by its fall to the east. */
function shaded(heights) {
    return heights.map((height, i) => {
        const east = heights[i - i % COLUMNS + (i + 1) % COLUMNS];
        return Math.min(Math.max(105 + height / 90 + (height - east) / 35, 30), 225);
    });
}
