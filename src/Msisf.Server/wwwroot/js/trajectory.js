// Trajectories: files that are dropped on the window, Kepler orbits, and how they look over the Moon.

import { readBatch } from './batch.js';
import { viewOf, scale, normalize, pointAt, REFERENCE_RADIUS } from './geometry.js';
import { footprint } from './overview.js';
import { postJson } from './server.js';

const $ = id => document.getElementById(id);
const GM = 4.902800118e12; // m^3/s^2, of the Moon (DE440)
const ORBIT_STATES = 181;
const MOST_FOOTPRINTS = 12;

/** The six elements of a text such as {1.9e6, 0.05, 0.7, 1.1, 0.9, 2.0}, with or without --kepler-set; null where it is none. */
export function keplerOf(text) {
    const inside = /^\s*(?:(?:--kepler-set|-k)[\s=]+)?['"]?\{([^{}]*)\}['"]?\s*$/.exec(text)?.[1];
    const numbers = inside?.split(',').map(word => (word.trim() === '' ? NaN : Number(word)));
    return numbers?.length === 6 && numbers.every(Number.isFinite) && numbers[0] > 0 ? numbers : null;
}

/** The states of a batch file, an OEM or a Kepler orbit; what the page cannot read, the server does. */
export async function statesOf(name, text, mjd) {
    const elements = keplerOf(text);
    if (elements) {
        const period = 2 * Math.PI * Math.sqrt(elements[0] ** 3 / GM) / 86400;
        const times = Array.from({ length: ORBIT_STATES }, (_, index) => mjd + period * index / (ORBIT_STATES - 1));
        return (await postJson('/v1/trajectory', { frame: { 'kepler-set': elements, epoch: mjd }, times })).states;
    }
    if (!/^\s*(CCSDS|<\?xml)/.test(text)) {
        try {
            return readBatch(text);
        } catch (error) {
            if (!/columns/.test(error.message)) {
                throw new Error(`${name}, ${error.message}`);
            }
        }
    }
    return (await postJson('/v1/trajectory', { name, text })).states;
}

/** Opens files that are dropped on the window. */
export function openDropped(onFile) {
    window.addEventListener('dragover', event => event.preventDefault());
    window.addEventListener('drop', event => {
        event.preventDefault();
        const [file] = event.dataTransfer.files;
        if (file) {
            onFile(file);
        }
    });
}

/** Draws the line below a list of states, the line of the flight, and the footprints of some of them. */
export function drawTrajectory(overlay, states, size, fov) {
    if (!$('show-trajectory').checked || states.length < 2) {
        return;
    }
    const positions = states.map(([, x, y, z]) => [x, y, z]);
    overlay.line(positions.map(point => scale(normalize(point), REFERENCE_RADIUS)), '#ff9f6b');
    overlay.free(positions, '#ffd0a8', [4, 4]);
    const every = Math.max(1, Math.ceil((states.length - 1) / MOST_FOOTPRINTS));
    for (let index = 0; index < states.length; index += every) {
        const places = footprint({ ...viewOf(states[index]), fov }, size, 8).map(({ latitude, longitude }) => pointAt(latitude, longitude));
        if (places.length > 2) {
            overlay.line([...places, places[0]], 'rgba(255, 159, 107, 0.75)');
        }
    }
}
