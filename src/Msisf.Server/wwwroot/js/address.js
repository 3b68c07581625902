// The page's address: it holds what is looked at and what is marked, so that a reload or a bookmark brings it back.
// Of the pins it has the places; what was read there is long, and kept beside it for a reload.

import { pointAt } from './geometry.js';
import { LETTERS } from './readings.js';

const $ = id => document.getElementById(id);

/** Fields that the address holds by these names: what is shown over the picture. */
const FIELDS = {
    layer: 'layer-choice', opacity: 'layer-opacity', craters: 'catalogue', landmarks: 'landmarks',
    grid: 'show-grid', terminator: 'show-terminator', arrow: 'show-arrow', names: 'show-names', contours: 'show-contours',
    overview: 'show-overview', longitudes: 'longitudes', second: 'second-time', path: 'path',
};

const LONGEST = 40; // letters of a value that cannot be used, in a message

const valueOf = field => (field.type === 'checkbox' ? String(field.checked) : field.value);

const firstValueOf = field => (field.type === 'checkbox' ? String(field.defaultChecked)
    : field.options ? field.options[0].value : field.defaultValue);

function put(field, value) {
    if (field.type === 'checkbox') {
        field.checked = value === 'true';
    } else {
        field.value = value;
    }
    return valueOf(field) === value;
}

/** Sets a field as a hand does; what it does not take makes it as at first. Answers whether it took the value. */
function set(field, value) {
    const isTaken = put(field, value) || !put(field, firstValueOf(field));
    field.dispatchEvent(new Event(field.type === 'range' ? 'input' : 'change'));
    return isTaken;
}

/** The place of a pin: degrees, m. */
const pinText = ({ latitude, longitude, height }) => [latitude, longitude, height].map(number => Number(number.toFixed(7))).join(',');

/** A pin from a text of the address; null where it is none. */
function pinOf(text) {
    const [latitude, longitude, height = 0, ...more] = text.split(',').map(word => (word.trim() === '' ? NaN : Number(word)));
    return more.length === 0 && Math.abs(latitude) <= 90 && Number.isFinite(longitude) && Number.isFinite(height)
        ? { latitude, longitude, height, position: pointAt(latitude, longitude, height) } : null;
}

export class Address {
    #isRead = false;
    #view = null;

    constructor(state, readings) {
        Object.assign(this, { state, readings });
        for (const id of Object.values(FIELDS)) {
            $(id).addEventListener('change', () => this.write());
        }
    }

    /**
     * Writes it anew; not before it was read.
     * @param isVisit whether another view than before is an entry of the browser's history, which its Back returns to.
     */
    write(isVisit = false) {
        if (!this.#isRead) {
            return;
        }
        const view = this.state.toText();
        const isEntry = isVisit && this.#view !== null && view !== this.#view;
        this.#view = view;
        const parameters = new URLSearchParams(view);
        for (const [name, id] of Object.entries(FIELDS)) {
            if (valueOf($(id)) !== firstValueOf($(id))) {
                parameters.set(name, valueOf($(id)));
            }
        }
        const { pins } = this.readings;
        if (pins.length > 0) {
            parameters.set('pins', pins.map(pinText).join(';'));
        }
        history[isEntry ? 'pushState' : 'replaceState']({ pins }, '', `#${parameters}`);
    }

    /** Takes the pins of the address, with all that was read there if the browser still has it. Answers whether it could. */
    #readPins(text) {
        if (!text) {
            this.readings.pins = [];
            return true;
        }
        const kept = history.state?.pins;
        if (kept?.map(pinText).join(';') === text) {
            this.readings.pins = kept;
            return true;
        }
        const pins = text.split(';').map(pinOf);
        const isRight = pins.every(Boolean) && pins.length <= LETTERS.length;
        this.readings.pins = isRight ? pins : [];
        return isRight;
    }

    /** Takes over what was written, once the fields have their choices. @returns words about what cannot be used; null if all can. */
    read(models) {
        this.#isRead = false;
        const parameters = new URLSearchParams(location.hash.slice(1));
        const unused = [];
        for (const [name, id] of Object.entries(FIELDS)) {
            if (!set($(id), parameters.get(name) ?? firstValueOf($(id)))) {
                unused.push([name, parameters.get(name)]);
            }
            parameters.delete(name);
        }
        if (!this.#readPins(parameters.get('pins'))) {
            unused.push(['pins', parameters.get('pins')]);
        }
        parameters.delete('pins');
        unused.push(...this.state.fromText(parameters, models));
        [this.#isRead, this.#view] = [true, null];
        const words = unused.map(([name, value]) => `${name}=${value}`.slice(0, LONGEST));
        return words.length > 0 ? `The page cannot use this of its address, and shows what it has without it: ${words.join(', ')}.` : null;
    }
}
