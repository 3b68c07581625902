// A frame as others take it: a command line, a line of a batch file, Python. Pure functions.

import { batchLine } from './batch.js';

const quoted = text => (/^[\w.,:/+-]+$/.test(text) ? text : `'${text.replaceAll("'", "'\\''")}'`);

/** The command that draws a frame; models are {name, pixels_per_degree}. */
export function commandLine(frame, models) {
    const { 'fixed-state': state, model, ...options } = frame;
    const used = models.find(({ name }) => name === model) ?? models[0];
    const words = ['msis', '--renderer', 'native', '--fixed-state', `'{${state.map(String).join(',')}}'`];
    for (const [name, value] of Object.entries({ ...options, ...(used && { res: used.pixels_per_degree }) })) {
        words.push(`--${name}`, quoted(String(value)));
    }
    return words.join(' ');
}

export const batchLineOf = frame => batchLine(frame['fixed-state']);

/** The same over the server, with nothing but Python's own library. */
export function python(frame, address) {
    const entries = Object.entries(frame).map(([name, value]) => `    ${JSON.stringify(name)}: ${JSON.stringify(value)},`);
    return [
        'import json, urllib.request',
        '',
        'frame = {',
        ...entries,
        '}',
        `request = urllib.request.Request("${address}/v1/render", json.dumps(frame).encode(),`,
        '                                 {"Content-Type": "application/json", "Accept": "image/png"})',
        'with urllib.request.urlopen(request) as answer, open("moon.png", "wb") as file:',
        '    file.write(answer.read())',
        '',
    ].join('\n');
}
