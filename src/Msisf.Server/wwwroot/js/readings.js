// The truth under the mouse and at two pins, as a table; and what lies between the pins.

import { enclosedArea, groundDistance, length, subtract } from './geometry.js';
import { areaText, degrees, fixed, latitudeText, lengthText } from './text.js';

/** What pins are called, in their order; there are no more. */
export const LETTERS = 'ABCDEFGHIJKLMNOPQRSTUVWXYZ';

/** The rows of the table: a name, and how a reading's value is written. */
const ROWS = [
    ['Latitude', reading => latitudeText(reading.latitude)],
    ['Longitude E', reading => degrees(reading.longitude, 6)],
    ['Height', reading => `${fixed(reading.height, 2)} m${reading.facet?.invented ? ', INVENTED' : ''}`],
    ['Incidence', reading => degrees(reading.incidence, 4)],
    ['Emission', reading => degrees(reading.emission, 4)],
    ['Phase', reading => degrees(reading.phase, 4)],
    ['Light from', reading => (reading.illumination_direction === null ? 'no direction' : degrees(reading.illumination_direction, 3))],
    ['Light', reading => (reading.lit === 'penumbra' ? `penumbra, ${fixed(100 * reading.lit_fraction, 0)} % of the Sun` : reading.lit)],
    ['Pixel covers', reading => lengthText(reading.pixel_scale)],
    ['Distance', reading => lengthText(reading.distance)],
    ['Slope', reading => degrees(reading.slope, 2)],
    ['Facet', reading => `${reading.facet.line}, ${reading.facet.sample} ${HALVES[reading.facet.half]}`],
    ['Pixel', reading => reading.pixel.join(', ')],
];

/** Names of the two facets of a cell, as the meta file has them. */
const HALVES = ['SW', 'NE'];

const HINTS = {
    Height: 'Over the sphere of 1,737.4 km; INVENTED where the ground is below the elevation model\'s resolution',
    Incidence: 'From the ground\'s normal to the Sun',
    Emission: 'From the ground\'s normal to the camera',
    Phase: 'From the Sun to the camera, seen from the ground',
    'Light from': 'Direction to the Sun along the ground, in the image: 0 down, 90 right, 180 up, 270 left',
    'Pixel covers': 'Across the line of sight',
    Slope: 'From the ground\'s normal to the vertical',
    Facet: 'Line, sample and half of the cell of the elevation model',
    Pixel: 'The first is 1, 1',
};

/** What is known of a pin that comes from the page's address. */
const OF_PLACE = ['Latitude', 'Longitude E', 'Height'];

/** Column A is the first pin, B the last of several. */
const COLUMNS = ['here', 'A', 'B'];

/** m: along the great circles between points, one after another. */
export const pathLength = points => points.slice(1).reduce((sum, point, index) => sum + groundDistance(points[index], point), 0);

/** What is measured between the first pin and the last: of two also straight, of more along the path and around it. */
function pathText(pins) {
    const [points, from, to] = [pins.map(({ position }) => position), pins[0], pins.at(-1)];
    const rise = `${to.height < from.height ? '' : '+'}${fixed(to.height - from.height, 2)} m in height`;
    const along = `${lengthText(pathLength(points))} great-circle distance`;
    return pins.length === 2
        ? `From A to B: ${along}, ${lengthText(length(subtract(to.position, from.position)))} straight, ${rise}.`
        : `From A to ${LETTERS[pins.length - 1]} over ${pins.length} points: ${along}, ${rise}. `
            + `Closed to A they enclose ${areaText(enclosedArea(points))}.`;
}

export class Readings {
    #here = null;
    #pins = [];
    #cells = {};

    /** @param isPath answers whether each pin adds a point; @param onChange is called when a reading has changed. */
    constructor(table, between, isPath, onChange) {
        Object.assign(this, { between, isPath, onChange });
        const body = table.tBodies[0];
        for (const [name] of ROWS) {
            const row = body.insertRow();
            const head = document.createElement('th');
            head.scope = 'row';
            head.textContent = name;
            head.title = HINTS[name] ?? '';
            row.append(head);
            this.#cells[name] = Object.fromEntries(COLUMNS.map(column => [column, row.insertCell()]));
            for (const column of COLUMNS) {
                this.#cells[name][column].dataset.column = column;
                this.#cells[name][column].dataset.row = name;
            }
        }
        this.table = table;
        this.#write();
    }

    /** What is read under the mouse, with its pixel, or null. */
    get here() {
        return this.#here;
    }

    set here(reading) {
        this.#here = reading;
        this.#write();
        this.onChange();
    }

    /** Keeps a reading: as A, then as B, then B anew; of a path as one point more. */
    pin(reading) {
        if (reading) {
            const most = this.isPath() ? LETTERS.length : 2;
            this.pins = [...this.#pins.slice(0, Math.max(most - 1, this.#pins.length - 1)), reading];
        }
    }

    /** Takes the pins away; of a path the last one. */
    unpin() {
        this.pins = this.isPath() ? this.#pins.slice(0, -1) : [];
    }

    /** The readings of the pins, in their order. */
    get pins() {
        return this.#pins;
    }

    set pins(pins) {
        this.#pins = pins;
        this.#write();
        this.onChange();
    }

    /** One sentence for those who do not see the table. */
    get sentence() {
        const here = this.#here;
        return here
            ? `${latitudeText(here.latitude)}, ${degrees(here.longitude, 6)} east, height ${fixed(here.height, 0)} metres, `
                + `${here.facet.invented ? 'invented ground, ' : ''}${here.lit}`
            : 'No Moon here';
    }

    /** The readings with all digits, as JSON. */
    get json() {
        const pins = Object.fromEntries(this.#pins.map((pin, index) => [LETTERS[index], pin]));
        return JSON.stringify({ here: this.#here, A: null, B: null, ...pins }, null, 2);
    }

    #write() {
        const pins = this.#pins;
        const last = pins.length > 1 ? pins.at(-1) : null;
        const shown = { here: this.#here, A: pins[0] ?? null, B: last };
        for (const [name, textOf] of ROWS) {
            for (const column of COLUMNS) {
                const reading = shown[column];
                const cell = this.#cells[name][column];
                cell.textContent = reading && (reading.facet || OF_PLACE.includes(name)) ? textOf(reading) : '–';
                if (name === 'Light') {
                    cell.className = reading?.lit ?? '';
                }
            }
        }
        this.table.hidden = COLUMNS.every(column => !shown[column]);
        this.table.dataset.pins = (shown.A ? 'A' : '') + (shown.B ? 'B' : '');
        this.table.tHead.rows[0].cells[3].textContent = `Pin ${LETTERS[Math.max(pins.length - 1, 1)]}`;
        this.between.textContent = last ? pathText(pins)
            : shown.A ? 'Pin a second place to measure from A to it.'
            : 'Point at the picture to read it. Click, or press P, to pin a place.';
    }
}

/** Asks for readings one after another: of the pixels that come while one is asked, only the newest counts. */
export class Reader {
    #next = undefined;
    #isAsking = false;

    /** @param ask gets a pixel and answers a promise of its reading. */
    constructor(ask, onReading) {
        Object.assign(this, { ask, onReading });
    }

    read(pixel) {
        this.#next = pixel;
        if (!this.#isAsking) {
            this.#work();
        }
    }

    async #work() {
        this.#isAsking = true;
        while (this.#next !== undefined) {
            const pixel = this.#next;
            this.#next = undefined;
            const reading = pixel ? await this.ask(pixel).catch(() => null) : null;
            if (this.#next === undefined || reading) {
                this.onReading(reading && { ...reading, pixel });
            }
        }
        this.#isAsking = false;
    }
}
