// The truth under the mouse and at two pins, as a table; and what lies between the pins.

import { groundDistance, length, subtract } from './geometry.js';
import { degrees, fixed, latitudeText, lengthText } from './text.js';

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

const COLUMNS = ['here', 'A', 'B'];

export class Readings {
    #read = { here: null, A: null, B: null };
    #cells = {};

    /** @param onChange is called when a reading has changed. */
    constructor(table, between, onChange) {
        this.between = between;
        this.onChange = onChange;
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

    /** A reading with its pixel, or null. */
    get(column) {
        return this.#read[column];
    }

    set(column, reading) {
        this.#read[column] = reading;
        this.#write();
        this.onChange();
    }

    /** Keeps a reading: as A, then as B, then B anew. */
    pin(reading) {
        if (reading) {
            this.set(this.#read.A ? 'B' : 'A', reading);
        }
    }

    unpin() {
        this.pins = {};
    }

    /** The readings of both pins, A and B; null where there is none. */
    get pins() {
        const { A, B } = this.#read;
        return { A, B };
    }

    set pins({ A = null, B = null }) {
        Object.assign(this.#read, { A, B });
        this.#write();
        this.onChange();
    }

    /** One sentence for those who do not see the table. */
    get sentence() {
        const here = this.#read.here;
        return here
            ? `${latitudeText(here.latitude)}, ${degrees(here.longitude, 6)} east, height ${fixed(here.height, 0)} metres, `
                + `${here.facet.invented ? 'invented ground, ' : ''}${here.lit}`
            : 'No Moon here';
    }

    /** The readings with all digits, as JSON. */
    get json() {
        return JSON.stringify(this.#read, null, 2);
    }

    #write() {
        for (const [name, textOf] of ROWS) {
            for (const column of COLUMNS) {
                const reading = this.#read[column];
                const cell = this.#cells[name][column];
                cell.textContent = reading && (reading.facet || OF_PLACE.includes(name)) ? textOf(reading) : '–';
                if (name === 'Light') {
                    cell.className = reading?.lit ?? '';
                }
            }
        }
        this.table.hidden = COLUMNS.every(column => !this.#read[column]);
        this.table.dataset.pins = (this.#read.A ? 'A' : '') + (this.#read.B ? 'B' : '');
        const { A, B } = this.#read;
        this.between.textContent = A && B
            ? `From A to B: ${lengthText(groundDistance(A.position, B.position))} great-circle distance, `
                + `${lengthText(length(subtract(B.position, A.position)))} straight, `
                + `${B.height < A.height ? '' : '+'}${fixed(B.height - A.height, 2)} m in height.`
            : A ? 'Pin a second place to measure from A to it.' : 'Point at the picture to read it. Click, or press P, to pin a place.';
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
