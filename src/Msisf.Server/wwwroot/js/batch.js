// Batch files of states: pure functions. A line is MJD rx ry rz qx qy qz q0, as docs/command-line-rules.md has it.

import { mjdOf } from './time.js';

const NAMES = { mjd: 0, time: 0, x: 1, rx: 1, y: 2, ry: 2, z: 3, rz: 3, qx: 4, qy: 5, qz: 6, qw: 7, q0: 7 };

/** The states of a batch file's text. @throws Error that names the first line that cannot be read. */
export function readBatch(text) {
    const states = [];
    let order = null;
    for (const [index, raw] of text.split(/\r?\n/).entries()) {
        const words = raw.replace(/#.*/, '').trim().split(/[\s,]+/).filter(Boolean).map(word => word.replace(/^"|"$/g, ''));
        if (words.length === 0) {
            continue;
        }
        if (states.length === 0 && order === null && words.some(word => word.toLowerCase() in NAMES)) {
            order = words.map(word => NAMES[word.toLowerCase()]);
            if (new Set(order.filter(place => place !== undefined)).size < 8) {
                throw new Error(`line ${index + 1}: the page reads columns for time, x, y, z, qx, qy, qz and qw; `
                    + 'for the other columns start msis view with the file.');
            }
            continue;
        }
        const state = Array(8).fill(NaN);
        for (const [column, word] of words.entries()) {
            const place = order ? order[column] : column;
            if (place !== undefined && place < 8) {
                state[place] = place === 0 && word.includes('T') ? mjdOf(word) ?? NaN : Number(word);
            }
        }
        if (!state.every(Number.isFinite)) {
            throw new Error(`line ${index + 1}: a state is eight numbers (MJD rx ry rz qx qy qz q0); here are ${words.length} words, `
                + 'or one that is no number.');
        }
        states.push(state);
    }
    if (states.length === 0) {
        throw new Error('there is no state in the file.');
    }
    return states;
}

/** A state as a line of a batch file: numbers that read back to the last bit. */
export const batchLine = state => state.map(String).join(' ');

/** States as a batch file. */
export const writeBatch = states => `# MJD rx ry rz qx qy qz q0\n${states.map(batchLine).join('\n')}\n`;
