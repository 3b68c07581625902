// A frame as others take it: a command line, a line of a batch file, Python. Pure functions.

import { batchLine } from './batch.js';

const quoted = text => (/^[\w.,:/+-]+$/.test(text) ? text : `'${text.replaceAll("'", "'\\''")}'`);

/** The models that a frame is drawn from: as the server chooses them. */
function modelsOf({ model, res }, models) {
    const names = models.some(({ name }) => name === model) ? [model] : (model ?? '').split('+');
    const [first] = models.filter(({ whole_moon: whole, pixels_per_degree }) => whole && pixels_per_degree === (res ?? pixels_per_degree));
    return (model ? names.map(name => models.find(one => one.name === name)) : [first]).filter(Boolean);
}

/** The command that draws a frame; models are those of the server: {name, pixels_per_degree, whole_moon, path, ldem}. */
export function commandLine(frame, models) {
    const { 'fixed-state': state, model, ...options } = frame;
    const used = modelsOf(frame, models);
    const paths = used.length > 1 ? used.map(({ path }) => path) : used.map(({ ldem }) => ldem).filter(Boolean);
    const words = ['msis', '--renderer', 'native', '--fixed-state', `'{${state.map(String).join(',')}}'`,
        ...paths.flatMap(path => ['--ldem', quoted(path)])];
    for (const [name, value] of Object.entries({ ...options, ...(used.length === 1 && { res: used[0].pixels_per_degree }) })) {
        words.push(`--${name}`, quoted(String(value)));
    }
    return words.join(' ');
}

export const batchLineOf = frame => batchLine(frame['fixed-state']);

/** A value as Python writes it. */
function pythonOf(value) {
    if (Array.isArray(value)) {
        return `(${value.map(pythonOf).join(', ')}${value.length === 1 ? ',' : ''})`;
    }
    return typeof value === 'boolean' ? (value ? 'True' : 'False') : JSON.stringify(value);
}

/** The same with the package msisf, over the server at an address. */
export function python(frame, address) {
    const { 'fixed-state': [mjd, x, y, z, ...turn], width, height, fov, camera, ...options } = frame;
    const named = Object.entries(options).map(([name, value]) => `        ${name.replaceAll('-', '_')}=${pythonOf(value)},`);
    const used = camera === undefined ? `msisf.Camera(width=${width}, height=${height}, fov=${fov})` : pythonOf(camera);
    return [
        'import msisf  # pip install ./clients/python',
        '',
        `with msisf.Moon("${address}") as moon:`,
        '    frame = moon.render(',
        `        position=${pythonOf([x, y, z])},  # m, MOON_ME`,
        `        orientation_xyz0=${pythonOf(turn)},`,
        `        time=${mjd},  # MJD, UTC`,
        `        camera=${used},`,
        ...named,
        '    )',
        'frame.save("moon.png")  # frame.image is the array',
        '',
    ].join('\n');
}
