// The fields of the camera and the picture: they show the state and change it.

import { REFERENCE_RADIUS } from './geometry.js';

const $ = id => document.getElementById(id);

/** Fields of the view: how many decimals they show, and in what unit. */
const NUMBERS = {
    latitude: { decimals: 6 }, longitude: { decimals: 6 }, altitude: { decimals: 3, unit: 1000 }, fov: { decimals: 4 },
    heading: { decimals: 3 }, tilt: { decimals: 3 }, roll: { decimals: 3 }, mjd: { decimals: 8 },
};

const CHOICES = ['model', 'shading', 'sun', 'reflectance'];

export class Panel {
    #typed = null;

    constructor(state) {
        this.state = state;
        $('settings').addEventListener('input', event => this.#typed = event.target);
        for (const end of ['change', 'focusout']) {
            $('settings').addEventListener(end, () => this.#typed = null);
        }
        for (const [name, { unit = 1 }] of Object.entries(NUMBERS)) {
            $(name).addEventListener('change', event => {
                const number = event.target.valueAsNumber;
                if (Number.isFinite(number) && event.target.validity.valid) {
                    state.look({ [name]: number * unit });
                }
            });
        }
        for (const name of CHOICES) {
            $(name).addEventListener('change', event => state.draw({ [name]: event.target.value }));
        }
        $('samples').addEventListener('change', event => state.draw({
            samples: event.target.value === 'auto' ? 'auto' : Number(event.target.value),
        }));
        for (const id of ['refine', 'refine-here']) {
            $(id).addEventListener('change', event => state.draw({ refine: event.target.checked }));
        }
        $('seed').addEventListener('change', event => event.target.validity.valid && event.target.value
            && state.draw({ seed: event.target.valueAsNumber }));
        $('fit').addEventListener('change', event => state.draw({ fit: event.target.checked, ...state.size }));
        for (const name of ['width', 'height']) {
            $(name).addEventListener('change', event => event.target.validity.valid && event.target.value
                && state.draw({ ...state.size, [name]: event.target.valueAsNumber, fit: false }));
        }
        $('whole-moon').addEventListener('click', () => this.wholeMoon());
        $('look-down').addEventListener('click', () => state.look({ tilt: 0, roll: 0 }));
        $('look-ahead').addEventListener('click', () => state.look({ tilt: Panel.horizon(state.view.altitude), roll: 0 }));
        $('north-up').addEventListener('click', () => state.look({ heading: 0, roll: 0 }));
    }

    /** The tilt at which the sphere's horizon is in the middle of the image. */
    static horizon(altitude) {
        return altitude > 0 ? Math.atan2(REFERENCE_RADIUS, Math.sqrt(altitude * (2 * REFERENCE_RADIUS + altitude))) * 180 / Math.PI : 90;
    }

    /** Goes as far away as shows the whole Moon. */
    wholeMoon() {
        const { width, height } = this.state.size;
        const half = Math.tan(this.state.view.fov * Math.PI / 360) * Math.min(1, height / width);
        const distance = 1.1 * REFERENCE_RADIUS / Math.sin(Math.atan(half));
        this.state.look({ altitude: distance - REFERENCE_RADIUS, tilt: 0, roll: 0, heading: 0 });
    }

    /** Offers the names of a list in a field of choices, the one chosen first or by its value. */
    static offer(select, options, chosen) {
        select.append(...options.map(({ value, label }) => new Option(label ?? value, value)));
        select.value = chosen ?? select.options[0]?.value ?? '';
    }

    /** What the page offers: each model of the whole Moon, and the maps of parts in the one around them as one surface. */
    static modelChoices({ models, one_surface: surface = [] }) {
        const whole = models.filter(model => model.whole_moon).map(({ name, pixels_per_degree: resolution }) => (
            { value: name, label: `${name} (${resolution} px/deg)` }));
        whole.unshift({ value: '', label: 'By the size of a pixel' });
        return surface.length ? [...whole, { value: surface.join('+'), label: `${surface.join(' + ')} as one surface` }] : whole;
    }

    /** Writes the state into the fields; the one that is being typed in is left alone. */
    show() {
        const { view, picture, size } = this.state;
        const write = (id, value) => {
            const field = $(id);
            if (field !== this.#typed) {
                field.value = value;
            }
        };
        for (const [name, { decimals, unit = 1 }] of Object.entries(NUMBERS)) {
            write(name, Number((view[name] / unit).toFixed(decimals)));
        }
        for (const name of CHOICES) {
            write(name, picture[name] || $(name).options[0]?.value || '');
        }
        write('samples', picture.samples);
        write('width', size.width);
        write('height', size.height);
        $('fit').checked = picture.fit;
        $('refine').checked = picture.refine;
        write('seed', picture.seed);
        $('refine-note').hidden = !picture.refine;
    }
}
