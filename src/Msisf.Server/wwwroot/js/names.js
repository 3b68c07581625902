// Named features: the search, and their labels over the picture.

import { getJson } from './server.js';
import { lengthText, placeOfText, placeText } from './text.js';

const $ = id => document.getElementById(id);
const MOST_FOUND = 8;
const WHOLE_ROOM = 1.8; // diameters of a feature across the picture

/** Words without accents and apostrophes, in small letters: Abul Wafa finds Abul Wáfa, chang'e finds Chang’e. */
const wordsOf = text => text.normalize('NFD').replace(/[\p{M}'’]/gu, '').toLowerCase().split(/[^\p{L}\p{N}]+/u).filter(Boolean);

const LINES = /^(Rimae?|Dors[ua]m?|Catena|Vallis|Rupes|Montes|Promontorium) /;

const weightOf = ({ name, diameter }) => diameter * (LINES.test(name) ? 0.25 : 1);

/** How well a name fits a key, which has no blanks: 0 is it, 1 begins with it, 2 has a word that does, 3 holds it, 4 does not. */
function rankOf(name, wanted) {
    const words = wordsOf(name);
    const key = words.join('');
    if (!key.includes(wanted)) {
        return 4;
    }
    return key === wanted ? 0 : key.startsWith(wanted) ? 1
        : words.some((_, index) => words.slice(index).join('').startsWith(wanted)) ? 2 : 3;
}

/** The names that a text may mean, the best first and then the largest. Blanks, punctuation, accents and case do not matter. */
export function find(names, text) {
    const wanted = wordsOf(text).join('');
    return wanted === '' ? [] : names.map(feature => ({ feature, rank: rankOf(feature.name, wanted) }))
        .filter(({ rank }) => rank < 4).sort((a, b) => a.rank - b.rank || b.feature.diameter - a.feature.diameter)
        .slice(0, MOST_FOUND).map(({ feature }) => feature);
}

export class Names {
    #found = [];
    #chosen = -1;

    /** @param onReady is called when the names are there; @param isHalved says how longitudes are written. */
    constructor(state, onReady, onProblem, isHalved) {
        Object.assign(this, { state, isHalved });
        this.list = [];
        this.byWeight = [];
        this.source = '';
        this.field = $('search-text');
        this.found = $('search-found');
        getJson('/v1/names').then(({ names, source }) => {
            this.source = source;
            this.list = names;
            /** For labels: lines in the ground, which are long and thin, after what is round. */
            this.byWeight = names.map(feature => ({ ...feature, weight: weightOf(feature) })).sort((a, b) => b.weight - a.weight);
            onReady();
        }).catch(error => onProblem(error.message));
        this.field.addEventListener('input', () => this.#search());
        this.field.addEventListener('keydown', event => this.#key(event));
        this.field.addEventListener('blur', () => this.#close());
        this.found.addEventListener('pointerdown', event => {
            event.preventDefault();
            const item = event.target.closest('li');
            if (item) {
                this.#go(this.#found[[...this.found.children].indexOf(item)]);
            }
        });
        $('search').addEventListener('submit', event => event.preventDefault());
    }

    #search() {
        const text = this.field.value;
        const place = placeOfText(text);
        this.#found = place ? [{ ...place, name: placeText(place, this.isHalved()) }] : find(this.list, text);
        this.#chosen = this.#found.length ? 0 : -1;
        this.found.replaceChildren(...this.#found.map((feature, index) => {
            const item = document.createElement('li');
            item.id = `search-found-${index}`;
            item.role = 'option';
            const about = document.createElement('span');
            about.textContent = feature.diameter ? lengthText(feature.diameter).replace(/\.\d+ km/, ' km') : 'place';
            item.append(feature.name, about);
            return item;
        }));
        this.#show();
        const isNothing = text.trim().length > 1 && !this.#found.length;
        this.field.setCustomValidity(isNothing ? `Nothing among ${this.source} is called so.` : '');
        this.field.title = this.field.validationMessage;
    }

    #show() {
        this.found.hidden = this.#found.length === 0;
        this.field.setAttribute('aria-expanded', !this.found.hidden);
        for (const [index, item] of [...this.found.children].entries()) {
            item.setAttribute('aria-selected', index === this.#chosen);
        }
        if (this.#chosen >= 0) {
            this.field.setAttribute('aria-activedescendant', `search-found-${this.#chosen}`);
        } else {
            this.field.removeAttribute('aria-activedescendant');
        }
    }

    #key(event) {
        const step = { ArrowDown: 1, ArrowUp: -1 }[event.key];
        if (step && this.#found.length) {
            event.preventDefault();
            this.#chosen = (this.#chosen + step + this.#found.length) % this.#found.length;
            this.#show();
        } else if (event.key === 'Enter' && this.#chosen >= 0) {
            event.preventDefault();
            this.#go(this.#found[this.#chosen]);
        } else if (event.key === 'Escape') {
            this.#close();
            $('stage').focus();
        }
    }

    #close() {
        this.#found = [];
        this.#chosen = -1;
        this.#show();
    }

    /** Looks down on a feature from where it fills most of the picture; on a place from the same altitude. */
    #go({ name, latitude, longitude, diameter }) {
        const { fov } = this.state.view;
        const altitude = diameter ? Math.max(WHOLE_ROOM * diameter / (2 * Math.tan(fov * Math.PI / 360)), 5000) : this.state.view.altitude;
        this.field.value = name;
        this.#close();
        $('stage').focus();
        this.state.look({ latitude, longitude, altitude, tilt: 0, roll: 0 });
    }
}
