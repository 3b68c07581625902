// What is drawn over the picture: lines, labels, terminator, the light's arrow, pins, the crosshair.

import {
    cameraOf, circleAround, combine, focalLength, isOnNearSide, length, limbAngle, meetSphere, normalize, project, scale, seenParts,
    subtract, REFERENCE_RADIUS,
} from './geometry.js';

const COLOURS = { terminator: '#ffb347', arrow: '#ff6b6b', pin: '#ffe066', closing: 'rgb(255 224 102 / 0.4)', crosshair: '#ffffff' };

/** Points of the limb: between two it is at most 0.7 m off the circle. */
const LIMB_POINTS = 3600;

export class Overlay {
    /** @param canvas covers the picture; @param view and size say what camera the picture is of. */
    constructor(canvas, view, size) {
        this.canvas = canvas;
        this.context = canvas.getContext('2d');
        this.lens = { ...size, fov: view.fov };
        this.camera = cameraOf(view);
        this.unit = canvas.width / size.width;
        const pageText = parseFloat(getComputedStyle(document.documentElement).fontSize);
        this.text = Math.max(14, Math.round(14 / 16 * pageText * (window.devicePixelRatio || 1)));
        this.labels = [];
        this.context.clearRect(0, 0, canvas.width, canvas.height);
        this.context.font = `${this.text}px system-ui, sans-serif`;
        this.context.lineWidth = this.text / 10;
        this.context.textBaseline = 'middle';
    }

    /** Where a point of space is on the canvas, or null if the camera does not see its side of the Moon. */
    at(point) {
        const pixel = isOnNearSide(this.camera, point) ? project(this.camera, this.lens, point) : null;
        return pixel && this.of(pixel);
    }

    /** Where a pixel's middle is on the canvas. */
    of([x, y]) {
        return [(x - 0.5) * this.unit, (y - 0.5) * this.unit];
    }

    /** Draws the part of a line over the sphere that the camera sees. */
    line(points, colour, dash = []) {
        this.#stroke(seenParts(this.camera, points), colour, dash);
    }

    /** Draws a line through space, as far as the sphere does not hide it. */
    free(points, colour, dash = []) {
        const { position } = this.camera;
        const isSeen = point => {
            const way = subtract(point, position);
            const met = meetSphere(position, normalize(way));
            return !met || length(subtract(met, position)) > length(way);
        };
        const parts = [];
        let part = null;
        for (const point of points) {
            if (isSeen(point)) {
                if (part === null) {
                    parts.push(part = []);
                }
                part.push(point);
            } else {
                part = null;
            }
        }
        this.#stroke(parts, colour, dash);
    }

    /** Draws segments of the canvas: [x, y, x, y] of each. */
    segments(list, isThick) {
        const path = new Path2D();
        for (const [ax, ay, bx, by] of list) {
            path.moveTo(ax, ay);
            path.lineTo(bx, by);
        }
        this.context.strokeStyle = isThick ? 'rgba(255, 217, 160, 0.9)' : 'rgba(255, 217, 160, 0.5)';
        this.context.lineWidth = this.text / (isThick ? 9 : 14);
        this.context.stroke(path);
        this.context.lineWidth = this.text / 10;
    }

    /** m: no point of the sphere is nearer. */
    get nearest() {
        return Math.max(Math.abs(length(this.camera.position) - REFERENCE_RADIUS), 1);
    }

    /** Draws the sphere's limb: what ends there does not stand out into the sky. */
    drawLimb(colour) {
        this.#stroke([this.#limb()], colour);
    }

    /** The points of the limb that are in the picture. */
    limbSeen() {
        const { width, height } = this.lens;
        return this.#limb().filter(point => {
            const [x, y] = project(this.camera, this.lens, point) ?? [0, 0];
            return x > 0 && y > 0 && x <= width && y <= height;
        });
    }

    #limb() {
        const angle = limbAngle(this.camera);
        return angle === null ? []
            : circleAround(this.camera.position, angle, LIMB_POINTS).map(point => scale(point, REFERENCE_RADIUS));
    }

    #stroke(parts, colour, dash = []) {
        const path = new Path2D();
        const limit = 4 * Math.max(this.canvas.width, this.canvas.height);
        for (const part of parts) {
            let isDown = false;
            for (const point of part) {
                const pixel = project(this.camera, this.lens, point);
                const place = pixel && this.of(pixel);
                const isNear = place !== null && Math.abs(place[0]) < limit && Math.abs(place[1]) < limit;
                if (isNear) {
                    path[isDown ? 'lineTo' : 'moveTo'](...place);
                }
                isDown = isNear;
            }
        }
        this.context.strokeStyle = colour;
        this.context.setLineDash(dash);
        this.context.stroke(path);
        this.context.setLineDash([]);
    }

    /** Keeps labels out of boxes of the canvas, [left, top, right, bottom] of each. */
    keepOut(boxes) {
        this.labels.push(...boxes);
    }

    /** px²: how much of the canvas the Moon's sphere fills at most. */
    get moonArea() {
        const distance = length(this.camera.position);
        const all = this.canvas.width * this.canvas.height;
        if (distance <= REFERENCE_RADIUS) {
            return all;
        }
        const focal = focalLength(this.lens.width, this.lens.fov) * this.unit;
        const radius = focal * REFERENCE_RADIUS / Math.sqrt((distance - REFERENCE_RADIUS) * (distance + REFERENCE_RADIUS));
        return Math.min(all, Math.PI * radius ** 2);
    }

    /**
     * Writes a text, if it is within the picture and at least a gap away from all labels that are there.
     * @returns its box, [left, top, right, bottom]; null where there is no room.
     */
    label(text, [x, y], colour, align = 'left', gap = 0) {
        const width = this.context.measureText(text).width;
        const left = align === 'center' ? x - width / 2 : x;
        const box = [left, y - this.text / 2, left + width, y + this.text / 2];
        const isFree = box[0] >= 0 && box[1] >= 0 && box[2] <= this.canvas.width && box[3] <= this.canvas.height
            && this.labels.every(other => box[0] - gap > other[2] || box[2] + gap < other[0]
                || box[1] - gap > other[3] || box[3] + gap < other[1]);
        if (!isFree) {
            return null;
        }
        this.labels.push(box);
        this.context.textAlign = align;
        this.context.strokeStyle = 'rgba(0, 0, 0, 0.85)';
        this.context.lineWidth = this.text / 4;
        this.context.lineJoin = 'round';
        this.context.strokeText(text, x, y);
        this.context.lineWidth = this.text / 10;
        this.context.fillStyle = colour;
        this.context.fillText(text, x, y);
        return box;
    }

    /** The line on the sphere where the Sun's centre stands on the horizon. */
    drawTerminator(sunPosition) {
        this.line(circleAround(sunPosition, 90, 360).map(point => scale(point, REFERENCE_RADIUS)), COLOURS.terminator,
            [this.text / 2, this.text / 2]);
    }

    /** An arrow from a pixel towards the light: an angle from straight down, counter-clockwise. */
    drawArrow(pixel, angleDegrees) {
        const [x, y] = this.of(pixel);
        const angle = angleDegrees * Math.PI / 180;
        const [dx, dy] = [Math.sin(angle), Math.cos(angle)];
        const long = 4 * this.text;
        const [tipX, tipY] = [x + dx * long, y + dy * long];
        const head = this.text * 0.8;
        const path = new Path2D();
        path.moveTo(x, y);
        path.lineTo(tipX, tipY);
        for (const side of [1, -1]) {
            path.moveTo(tipX, tipY);
            path.lineTo(tipX - head * (dx + side * dy * 0.6), tipY - head * (dy - side * dx * 0.6));
        }
        this.strokeTwice(path, COLOURS.arrow);
    }

    /** A pin with its letter where a point of the surface is now. */
    drawPin(point, letter) {
        const place = this.at(point);
        if (place) {
            const path = new Path2D();
            path.arc(place[0], place[1], this.text / 2, 0, 2 * Math.PI);
            this.strokeTwice(path, COLOURS.pin);
            this.label(letter, [place[0] + this.text * 0.8, place[1] - this.text * 0.6], COLOURS.pin);
        }
    }

    /** The line on the sphere between two pins; fainter where it only closes an area. */
    drawWay(from, to, isClosing = false) {
        const lift = Array.from({ length: 65 }, (_, i) => combine([from, 1 - i / 64], [to, i / 64]));
        const radius = i => Math.hypot(...from) * (1 - i / 64) + Math.hypot(...to) * i / 64;
        this.line(lift.map((point, i) => scale(point, radius(i) / Math.hypot(...point))), isClosing ? COLOURS.closing : COLOURS.pin,
            [this.text / 3, this.text / 3]);
    }

    drawCrosshair(pixel) {
        const [x, y] = this.of(pixel);
        const path = new Path2D();
        for (const [dx, dy] of [[1, 0], [-1, 0], [0, 1], [0, -1]]) {
            path.moveTo(x + dx * this.text * 0.4, y + dy * this.text * 0.4);
            path.lineTo(x + dx * this.text * 1.4, y + dy * this.text * 1.4);
        }
        this.strokeTwice(path, COLOURS.crosshair);
    }

    /** In a dark line and in a bright one over it: to be seen on every ground. */
    strokeTwice(path, colour) {
        this.context.lineCap = 'round';
        for (const [style, width] of [['rgba(0, 0, 0, 0.8)', 3.2], [colour, 1.6]]) {
            this.context.strokeStyle = style;
            this.context.lineWidth = width * this.text / 10;
            this.context.stroke(path);
        }
        this.context.lineWidth = this.text / 10;
    }
}

