// What is looked at: the view, the picture's settings, and their form in the page's address, so that a reload brings them back.

import { stateOf, turn } from './geometry.js';
import { modelFor, pixelSize } from './models.js';

/** The Moon's near side, a day after the first quarter of April 2010. */
const FIRST_VIEW = { mjd: 55308, latitude: 0, longitude: 0, altitude: 3900000, heading: 0, tilt: 0, roll: 0, fov: 40 };

const FIRST_PICTURE = {
    fit: true, width: 1024, height: 1024, samples: 'auto', model: '', shading: 'smooth', sun: 'point', reflectance: '',
    refine: false, seed: 1,
};

/** The longer side of the images while the camera moves, px. */
export const MOVING_SIZE = 512;

/** The largest image that fits the window by itself: 4K. */
const MOST_PIXELS = 3840 * 2160;

/** How msis draws what the options of a frame do not say otherwise. */
const DEFAULT_PICTURE = { ...FIRST_PICTURE, fit: false, samples: 1, shading: 'facet' };

/** Samples that the page offers; as others a frame of a folder is drawn anew with those that are chosen. */
const SAMPLES = ['auto', 1, 4, 9, 16, 25];

/** The years 1 to 9999, MJD; which of them its kernels cover only the server knows. */
const YEARS = [-678575, 2973483.999];

/** Least and greatest numbers of the view. */
const LIMITS = { latitude: [-90, 90], altitude: [-9000, 1e9], tilt: [0, 180], fov: [0.01, 175], mjd: YEARS };

/** Least and greatest whole numbers of the picture. */
const WHOLE_LIMITS = { width: [1, 16384], height: [1, 16384], seed: [0, Number.MAX_SAFE_INTEGER] };

const isWithin = (number, [least, most] = [-Infinity, Infinity]) => Number.isFinite(number) && number >= least && number <= most;

/** What the address may hold of the picture. A law of reflectance may have parameters; only the server can tell which. */
const CHECKS = {
    samples: text => SAMPLES.map(String).includes(text),
    shading: text => ['facet', 'smooth'].includes(text),
    sun: text => ['point', 'disc'].includes(text),
    fit: text => ['true', 'false'].includes(text),
    refine: text => ['true', 'false'].includes(text),
    model: (text, models) => models.some(({ name, whole_moon: whole }) => name === text && whole)
        || (text.includes('+') && text.split('+').every(part => models.some(({ name }) => name === part))),
    reflectance: () => true,
};

/** The value that a text of the address has; undefined where it has none. */
function readValue(name, text, first, models) {
    const number = text.trim() === '' ? NaN : Number(text);
    const isUsable = CHECKS[name] ? CHECKS[name](text, models)
        : name in WHOLE_LIMITS ? Number.isInteger(number) && isWithin(number, WHOLE_LIMITS[name])
        : isWithin(number, LIMITS[name]);
    return !isUsable ? undefined
        : typeof first === 'number' || (name === 'samples' && text !== 'auto') ? number
        : typeof first === 'boolean' ? text === 'true' : text;
}

export class State {
    /** MJD that is looked at first. */
    static FIRST_TIME = FIRST_VIEW.mjd;

    #listeners = [];
    #before = null;

    constructor() {
        this.view = { ...FIRST_VIEW };
        this.picture = { ...FIRST_PICTURE };
        /** Options of the picture that the page has no field for: those of a frame of a folder. */
        this.own = {};
        this.window = { width: 1024, height: 1024 };
        /** The server's models, of which one is taken by the size of a pixel unless one is chosen. */
        this.models = [];
    }

    /** Calls a function after each change, with whether the picture of it is there already. */
    onChange(listener) {
        this.#listeners.push(listener);
    }

    /** Moves or turns the camera, or the time; a stored picture of the view need not be drawn. */
    look(changes, isStored = false) {
        const view = { ...this.view, ...changes };
        if (view.fov !== this.view.fov) {
            this.#leaveCamera();
        }
        for (const [name, [least, most]] of Object.entries(LIMITS)) {
            view[name] = Math.min(Math.max(view[name], least), most);
        }
        for (const name of ['longitude', 'heading']) {
            view[name] = turn(view[name]);
        }
        view.roll = turn(view.roll + 180) - 180;
        if (Object.values(view).every(Number.isFinite)) {
            this.view = view;
            this.#tell(isStored);
        }
    }

    /** Changes how the picture is drawn. */
    draw(changes) {
        if ('width' in changes || 'height' in changes) {
            this.#leaveCamera();
        }
        Object.assign(this.picture, changes);
        this.#tell(false);
    }

    /**
     * Takes over how a frame of a folder was drawn, for the view that is looked at next; null goes back to what was before the first.
     * @param options those of the frame, under the names of the command line, without its place. A camera's size and field of view are
     * among them.
     */
    adopt(options) {
        this.#before ??= this.picture;
        if (!options) {
            [this.picture, this.own, this.#before] = [this.#before, {}, null];
            return;
        }
        const { model, samples, shading, sun, reflectance, width, height, refine, fov = this.view.fov, ...own } = options;
        const known = {
            model, samples: SAMPLES.includes(samples) ? samples : undefined, shading, sun, reflectance, width, height,
            ...(refine !== undefined && { refine: true, seed: refine }),
        };
        const given = Object.fromEntries(Object.entries(known).filter(([, value]) => value !== undefined));
        this.picture = { ...DEFAULT_PICTURE, ...(samples !== undefined && { samples: this.#before.samples }), ...given };
        this.view = { ...this.view, fov };
        this.own = own;
    }

    /** A field of view or a size that is given by hand takes the place of the camera's. */
    #leaveCamera() {
        const { camera, ...own } = this.own;
        this.own = own;
    }

    /** The room for the picture, in px of the screen. */
    fitTo(width, height) {
        if (width !== this.window.width || height !== this.window.height) {
            this.window = { width, height };
            if (this.picture.fit) {
                this.#tell(false);
            }
        }
    }

    /** Width and height of the picture at rest. */
    get size() {
        if (!this.picture.fit) {
            return { width: this.picture.width, height: this.picture.height };
        }
        const factor = Math.min(1, Math.sqrt(MOST_PIXELS / (this.window.width * this.window.height)));
        return { width: Math.max(1, Math.round(this.window.width * factor)), height: Math.max(1, Math.round(this.window.height * factor)) };
    }

    /** Width and height while the camera moves: of the same shape. */
    get movingSize() {
        const { width, height } = this.size;
        const factor = Math.min(1, MOVING_SIZE / Math.max(width, height));
        return { width: Math.max(1, Math.round(width * factor)), height: Math.max(1, Math.round(height * factor)) };
    }

    /** Name of the model that is drawn; undefined where a frame of a folder names another, or before the models are known. */
    get model() {
        return this.picture.model
            || (this.own.res === undefined ? modelFor(this.models, pixelSize(this.view, this.size))?.name : undefined);
    }

    /** The frame of the view as the server takes it: options under the names of the command line. */
    frame({ width, height } = this.size, samples = 1) {
        const { shading, sun, reflectance, refine, seed } = this.picture;
        const { model } = this;
        return {
            'fixed-state': stateOf(this.view),
            ...(!this.own.camera && { fov: this.view.fov, width, height }),
            samples,
            ...(model && { model }),
            ...(shading !== DEFAULT_PICTURE.shading && { shading }),
            ...(sun !== FIRST_PICTURE.sun && { sun }),
            ...(reflectance && { reflectance }),
            ...(refine && { refine: seed }),
            ...this.own,
        };
    }

    /** All of it in the form of a query: only what is not as at first. */
    toText() {
        const parameters = new URLSearchParams();
        for (const [values, first] of [[this.view, FIRST_VIEW], [this.picture, FIRST_PICTURE]]) {
            for (const [name, value] of Object.entries(values)) {
                if (value !== first[name]) {
                    parameters.set(name, value);
                }
            }
        }
        return parameters.toString();
    }

    /** Takes over what toText wrote, as URLSearchParams. @returns names and texts of what cannot be used: that is as at first. */
    fromText(parameters, models) {
        const [view, picture, unused] = [{ ...FIRST_VIEW }, { ...FIRST_PICTURE }, []];
        for (const [name, text] of parameters) {
            const values = [view, picture].find(group => Object.hasOwn(group, name));
            const value = values && readValue(name, text, values[name], models);
            if (value === undefined) {
                unused.push([name, text]);
            } else {
                values[name] = value;
            }
        }
        this.picture = picture;
        this.look(view);
        return unused;
    }

    #tell(isStored) {
        for (const listener of this.#listeners) {
            listener(isStored);
        }
    }
}
