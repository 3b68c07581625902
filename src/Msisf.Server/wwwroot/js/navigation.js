// Mouse, touch and keys on the picture: orbit, look around, zoom, fly, and the place that is read.

import { REFERENCE_RADIUS, shifted, travelled } from './geometry.js';

const LOOK_RATE = 40; // degrees a second, of heading, tilt and roll, by keys
const LONG_PRESS = 500; // ms with a finger, which pins
const DECISION = 12; // px that two fingers move before it is said what they do
const MINIMUM_HEIGHT = 20; // m over the ground, which speeds and steps are measured by

/** What a held key does, per second; a step is the height over the ground. */
const HELD = {
    KeyW: { ahead: 1 }, KeyS: { ahead: -1 }, KeyA: { right: -1 }, KeyD: { right: 1 },
    KeyQ: { heading: -1 }, KeyE: { heading: 1 }, KeyR: { climb: 1 }, KeyF: { climb: -1 },
    ArrowUp: { tilt: 1 }, ArrowDown: { tilt: -1 }, ArrowLeft: { heading: -1 }, ArrowRight: { heading: 1 },
    BracketLeft: { roll: -1 }, BracketRight: { roll: 1 },
    NumpadAdd: { climb: -1 }, NumpadSubtract: { climb: 1 },
};

export class Navigation {
    #held = new Set();
    #pointers = new Map();
    #lastTime = 0;
    #pair = null;
    #press = 0;

    /**
     * @param ground says how high the terrain below the camera is, m over the reference radius.
     * @param onPoint gets the pixel under the mouse, or null.
     * @param onCrosshair gets [dx, dy] when arrows move the crosshair; it answers whether there is one.
     * @param onPin is told that the place that is read is to be pinned.
     */
    constructor(stage, state, { ground, onPoint, onCrosshair, onPin }) {
        Object.assign(this, { stage, state, ground, onPoint, onCrosshair, onPin });
        const area = stage.stage;
        area.addEventListener('pointerdown', event => this.#down(event));
        area.addEventListener('pointermove', event => this.#move(event));
        area.addEventListener('pointerup', event => this.#release(event));
        area.addEventListener('pointercancel', event => this.#release(event));
        area.addEventListener(
            'pointerleave', event => event.pointerType === 'mouse' && this.#pointers.size === 0 && onPoint(null));
        area.addEventListener('contextmenu', event => event.preventDefault());
        area.addEventListener('wheel', event => this.#wheel(event), { passive: false });
        area.addEventListener('keydown', event => this.#keyDown(event));
        area.addEventListener('keyup', event => this.#held.delete(event.code));
        area.addEventListener('blur', () => this.#held.clear());
    }

    /** Whether keys or fingers move the camera just now. */
    get isMoving() {
        return this.#held.size > 0 || [...this.#pointers.values()].some(pointer => pointer.moved);
    }

    /** Height over the ground below the camera, m. */
    get #height() {
        return Math.max(this.state.view.altitude - this.ground(), MINIMUM_HEIGHT);
    }

    /** Makes the height over the ground so many times as large. */
    climb(factor) {
        this.state.look({ altitude: this.ground() + this.#height * factor });
    }

    #down(event) {
        if (event.target.closest('button, input, select')) {
            return;
        }
        this.stage.stage.setPointerCapture(event.pointerId);
        const [x, y] = [event.clientX, event.clientY];
        this.#pointers.set(event.pointerId, { x, y, startX: x, startY: y, moved: false });
        this.#pair = this.#pointers.size === 2 ? this.#pairNow() : null;
        clearTimeout(this.#press);
        if (event.pointerType === 'touch' && this.#pointers.size === 1) {
            this.#press = setTimeout(() => this.#longPress(event), LONG_PRESS);
        }
    }

    #move(event) {
        const pointer = this.#pointers.get(event.pointerId);
        if (!pointer) {
            this.onPoint(this.stage.pixelAt(event.clientX, event.clientY));
            return;
        }
        const [dx, dy] = [event.clientX - pointer.x, event.clientY - pointer.y];
        Object.assign(pointer, { x: event.clientX, y: event.clientY });
        pointer.moved ||= Math.hypot(event.clientX - pointer.startX, event.clientY - pointer.startY) > 3;
        if (!pointer.moved) {
            return;
        }
        clearTimeout(this.#press);
        if (this.#pointers.size === 2) {
            this.#movePair();
        } else if (event.shiftKey || (event.buttons & 2) !== 0) {
            this.#turn(dx, dy);
        } else {
            this.#orbit(dx, dy);
        }
    }

    /** A press without a way is a click: it pins the place. A finger reads; one that stays pins. */
    #release(event) {
        const pointer = this.#pointers.get(event.pointerId);
        this.#pointers.delete(event.pointerId);
        this.#pair = null;
        clearTimeout(this.#press);
        if (pointer && !pointer.moved && event.type === 'pointerup') {
            this.onPoint(this.stage.pixelAt(event.clientX, event.clientY));
            if (event.pointerType !== 'touch') {
                this.onPin();
            }
        }
    }

    #longPress(event) {
        const pointer = this.#pointers.get(event.pointerId);
        if (pointer && !pointer.moved) {
            pointer.moved = true; // lifting the finger is no tap any more
            this.onPoint(this.stage.pixelAt(event.clientX, event.clientY));
            this.onPin();
            this.#pointers.delete(event.pointerId);
        }
    }

    /** How two fingers lie: distance, middle, direction. */
    #pairNow() {
        const [a, b] = [...this.#pointers.values()];
        return { spread: Math.hypot(a.x - b.x, a.y - b.y), y: (a.y + b.y) / 2, angle: Math.atan2(b.y - a.y, b.x - a.x), does: null };
    }

    /** Two fingers pinch and turn, or tilt when both go up or down; which of both they do is decided once. */
    #movePair() {
        const [before, now] = [this.#pair ?? this.#pairNow(), this.#pairNow()];
        const [wider, lower] = [Math.abs(now.spread - before.spread), Math.abs(now.y - before.y)];
        const turned = Math.abs(now.angle - before.angle) * now.spread / 2;
        const does = before.does ?? (Math.max(wider, lower, turned) < DECISION ? null
            : lower > Math.max(wider, turned) ? 'tilt' : 'pinch');
        if (does === null) {
            this.#pair = before;
            return;
        }
        this.#pair = { ...now, does };
        if (does === 'tilt') {
            this.state.look({ tilt: this.state.view.tilt - (now.y - before.y) * 0.3 });
        } else {
            const turn = Math.atan2(Math.sin(now.angle - before.angle), Math.cos(now.angle - before.angle));
            this.climb(Math.max(before.spread, 1) / Math.max(now.spread, 1));
            this.state.look({ heading: this.state.view.heading - turn * 180 / Math.PI });
        }
    }

    /** Degrees that a pixel of the page is in the image's middle, seen from the camera. */
    get #anglePerPixel() {
        return this.state.view.fov / Math.max(1, this.stage.picture.clientWidth);
    }

    /** The ground follows the mouse, so the camera goes the other way. */
    #orbit(dx, dy) {
        const view = this.state.view;
        const metres = this.#anglePerPixel * Math.PI / 180 * this.#height;
        const degrees = metres / REFERENCE_RADIUS * 180 / Math.PI;
        const roll = view.roll * Math.PI / 180;
        const [right, up] = [dx * Math.cos(roll) + dy * Math.sin(roll), -dy * Math.cos(roll) + dx * Math.sin(roll)];
        this.state.look(shifted(view, -up * degrees, -right * degrees));
    }

    #turn(dx, dy) {
        const view = this.state.view;
        this.state.look({ heading: view.heading - dx * this.#anglePerPixel, tilt: view.tilt + dy * this.#anglePerPixel });
    }

    #wheel(event) {
        event.preventDefault();
        this.stage.stage.focus({ preventScroll: true });
        const notches = event.deltaY / (event.deltaMode === 1 ? 3 : 100);
        if (event.altKey) {
            this.state.look({ fov: this.state.view.fov * 1.1 ** notches });
        } else {
            this.climb(1.15 ** notches);
        }
    }

    #keyDown(event) {
        if (event.ctrlKey || event.metaKey || event.altKey || event.target.closest('input, select, textarea')) {
            return;
        }
        const arrow = { ArrowUp: [0, -1], ArrowDown: [0, 1], ArrowLeft: [-1, 0], ArrowRight: [1, 0] }[event.code];
        const step = event.shiftKey ? 20 : 1;
        if (arrow && this.onCrosshair(arrow.map(way => way * step))) {
            event.preventDefault();
        } else if (event.key === '+' || event.key === '-') {
            this.climb(event.key === '+' ? 1 / 1.15 : 1.15);
        } else if (HELD[event.code]) {
            event.preventDefault();
            this.#held.add(event.code);
            if (this.#held.size === 1 && !event.repeat) {
                this.#lastTime = performance.now();
                this.#step(0.05);
                requestAnimationFrame(time => this.#fly(time));
            }
        }
    }

    #fly(time) {
        if (this.#held.size === 0) {
            return;
        }
        const seconds = Math.min(Math.max(time - this.#lastTime, 0) / 1000, 0.1);
        this.#lastTime = time;
        this.#step(seconds);
        requestAnimationFrame(next => this.#fly(next));
    }

    /** What the held keys do in a time: a quarter of the height a second, or 40 degrees. */
    #step(seconds) {
        const sum = { ahead: 0, right: 0, climb: 0, heading: 0, tilt: 0, roll: 0 };
        for (const code of this.#held) {
            for (const [name, amount] of Object.entries(HELD[code])) {
                sum[name] += amount;
            }
        }
        const way = Math.min(this.#height * 0.5 * seconds / REFERENCE_RADIUS * 180 / Math.PI, 30 * seconds);
        const view = travelled(this.state.view, sum.ahead * way, sum.right * way);
        const rate = Math.min(LOOK_RATE, view.fov) * seconds;
        this.state.look({
            ...view,
            altitude: sum.climb === 0 ? view.altitude : this.ground() + this.#height * 3 ** (sum.climb * seconds),
            heading: view.heading + sum.heading * rate,
            tilt: view.tilt + sum.tilt * rate,
            roll: view.roll + sum.roll * rate,
        });
    }
}
