// The place that is read: under the mouse, at the crosshair, at pins.

import { Reader } from './readings.js';
import { readPixels } from './server.js';
import { State } from './state.js';
import { lengthText } from './text.js';

const $ = id => document.getElementById(id);

export class Pointing {
    #pointed = null;
    #reader;

    /** @param onRead gets each reading with its pixel, or null; @param onPins is called when a pin is set or taken away. */
    constructor(stage, picture, readings, onRead, onPins) {
        Object.assign(this, { stage, picture, readings, onPins });
        /** Pixel of the crosshair, or null. */
        this.crosshair = null;
        /** m: height of the terrain below the camera. */
        this.groundHeight = 0;
        this.#reader = new Reader(pixel => this.#ask(pixel), reading => {
            readings.here = reading;
            onRead(reading);
            if (this.crosshair) {
                $('spoken').textContent = readings.sentence;
            }
        });
    }

    async #ask(pixel) {
        return (await readPixels(this.picture.shown.frame, [pixel])).at(0);
    }

    get #canRead() {
        return Boolean(this.picture.shown?.frame && this.picture.isAtRest);
    }

    /** Reads a pixel of the picture, as soon as it is at rest. */
    point(pixel) {
        this.#pointed = pixel;
        if (this.#canRead) {
            this.#reader.read(pixel);
        }
    }

    /** Reads the same pixel of a new picture. */
    again() {
        this.point(this.crosshair ?? this.#pointed);
    }

    /** How high the terrain below the camera is: one pixel that looks straight down. */
    async findGround(state) {
        const { view } = state;
        const down = new State();
        down.picture = { ...state.picture };
        down.models = state.models;
        down.look({ ...view, tilt: 0, roll: 0, fov: 1 });
        const [reading] = await readPixels({ ...down.frame({ width: 1, height: 1 }), model: state.model }, [[1, 1]]).catch(() => [null]);
        if (reading && view === state.view) {
            this.groundHeight = reading.height;
            $('over-terrain').textContent = lengthText(view.altitude - this.groundHeight);
        }
    }

    /** Pins what is read; a click may come before its reading does. */
    async pin() {
        const pixel = this.crosshair ?? this.#pointed;
        if (!pixel || !this.#canRead) {
            return;
        }
        const here = this.readings.here;
        const isRead = here?.pixel.every((number, axis) => number === pixel[axis]);
        const reading = isRead ? here : await this.#ask(pixel).catch(() => null);
        this.readings.pin(reading && { ...reading, pixel });
        this.onPins();
        $('spoken').textContent = reading ? $('between').textContent : 'There is no Moon to pin here.';
    }

    unpin() {
        this.readings.unpin();
        this.onPins();
    }

    #setCrosshair(pixel) {
        this.crosshair = pixel;
        $('crosshair').setAttribute('aria-pressed', pixel !== null);
        this.point(pixel);
    }

    toggleCrosshair() {
        const { width, height } = this.picture.shown?.size ?? this.stage.size;
        this.#setCrosshair(this.crosshair ? null : [Math.ceil(width / 2), Math.ceil(height / 2)]);
    }

    /** Moves the crosshair; answers whether there is one. */
    moveCrosshair([dx, dy]) {
        if (!this.crosshair) {
            return false;
        }
        const { width, height } = this.picture.shown.size;
        const [x, y] = this.crosshair;
        this.#setCrosshair([Math.min(Math.max(x + dx, 1), width), Math.min(Math.max(y + dy, 1), height)]);
        return true;
    }
}
