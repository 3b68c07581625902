// Ground truth as colours: which layers there are, and pictures of their values.

import { degrees, lengthText } from './text.js';

/** Colours of the mask's states: no Moon, lit, penumbra, shadow, night. */
const STATES = [
    { colour: [0, 0, 0, 0] },
    { label: 'lit', colour: [253, 231, 37, 255] },
    { label: 'penumbra', colour: [94, 201, 98, 255] },
    { label: 'shadow', colour: [59, 82, 139, 255] },
    { label: 'night', colour: [68, 1, 84, 255] },
];

/** The layers on offer. A range is fixed where one can say beforehand what its ends mean. */
export const LAYERS = {
    height: { label: 'Height', text: value => lengthText(value) },
    slope: { label: 'Slope', range: [0, 45], text: value => degrees(value, 0) },
    incidence: { label: 'Incidence', range: [0, 90], text: value => degrees(value, 0) },
    'pixel-scale': { label: 'Resolution: side of a pixel', text: value => lengthText(value) },
    depth: { label: 'Depth along the line of sight', text: value => lengthText(value) },
    mask: { label: 'Light and shadow', states: STATES },
};

/** Viridis by Smith and van der Walt, in seven steps: its lightness grows evenly, for every kind of colour vision. */
const VIRIDIS = [[68, 1, 84], [68, 57, 131], [49, 104, 142], [33, 145, 140], [53, 183, 121], [144, 215, 67], [253, 231, 37]];

/** The colour of a part from 0 to 1. */
export function colourOf(part) {
    const place = Math.min(Math.max(part, 0), 1) * (VIRIDIS.length - 1);
    const index = Math.min(Math.floor(place), VIRIDIS.length - 2);
    return VIRIDIS[index].map((channel, i) => Math.round(channel + (VIRIDIS[index + 1][i] - channel) * (place - index)));
}

const TABLE = new Uint32Array(Array.from({ length: 256 }, (_, i) => {
    const [red, green, blue] = colourOf(i / 255);
    return (0xff000000 | blue << 16 | green << 8 | red) >>> 0;
}));

/** The least and the greatest value; null where there is none. */
export function rangeOf(values) {
    let [least, greatest] = [Infinity, -Infinity];
    for (const value of values) {
        if (value < least) {
            least = value;
        }
        if (value > greatest) {
            greatest = value;
        }
    }
    return least <= greatest ? [least, greatest] : null;
}

/** The values of a layer as a picture, and the range of its colours. What is undefined is transparent. */
export function colouredLayer(name, { width, height, values }) {
    const { states, range: known } = LAYERS[name];
    const pixels = new ImageData(width, height);
    const words = new Uint32Array(pixels.data.buffer);
    if (states) {
        const table = states.map(({ colour: [red, green, blue, alpha] }) => (alpha << 24 | blue << 16 | green << 8 | red) >>> 0);
        for (let i = 0; i < words.length; i++) {
            words[i] = table[values[i]];
        }
        return { pixels, range: null };
    }
    const range = known ?? rangeOf(values);
    if (range) {
        const factor = 255 / (range[1] - range[0] || 1);
        for (let i = 0; i < words.length; i++) {
            const place = (values[i] - range[0]) * factor;
            words[i] = Number.isNaN(place) ? 0 : TABLE[Math.min(Math.max(Math.round(place), 0), 255)];
        }
    }
    return { pixels, range };
}

/** Fills the scale beside the picture: a bar with its ends, or the states' colours. */
export function showScale(element, name, range) {
    const { label, states, text } = LAYERS[name];
    const title = document.createElement('p');
    title.textContent = label;
    element.replaceChildren(title);
    if (states) {
        for (const state of states.filter(item => item.label)) {
            const entry = document.createElement('span');
            const swatch = document.createElement('i');
            swatch.style.backgroundColor = `rgb(${state.colour.slice(0, 3)})`;
            entry.append(swatch, state.label);
            element.append(entry);
        }
    } else if (range) {
        const bar = document.createElement('canvas');
        bar.width = 256;
        bar.height = 1;
        const pixels = new ImageData(256, 1);
        new Uint32Array(pixels.data.buffer).set(TABLE);
        bar.getContext('2d').putImageData(pixels, 0, 0);
        const ends = document.createElement('div');
        for (const value of [range[0], (range[0] + range[1]) / 2, range[1]]) {
            const end = document.createElement('span');
            end.textContent = text(value);
            ends.append(end);
        }
        element.append(bar, ends);
    }
}
