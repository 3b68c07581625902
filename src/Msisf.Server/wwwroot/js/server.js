// What the page asks of the server that it came from.

/** The server refused or failed; the message has its words. */
export class ServerError extends Error {}

/** The server does not answer at all. */
export class LostError extends ServerError {}

async function checked(answer) {
    if (answer.ok) {
        return answer;
    }
    const problem = await answer.json().catch(() => null);
    throw new ServerError(problem?.detail ?? problem?.title ?? `the server answered ${answer.status} ${answer.statusText}`);
}

async function call(path, options) {
    let answer;
    try {
        answer = await fetch(path, options);
    } catch (error) {
        throw error.name === 'AbortError' ? error : new LostError('the server does not answer: is msis still running?');
    }
    return checked(answer);
}

const post = (path, body, accept, signal) => call(path, {
    method: 'POST',
    headers: { 'Content-Type': 'application/json', Accept: accept },
    body: JSON.stringify(body),
    signal,
});

/** Gets JSON. */
export const getJson = async (path, signal) => (await call(path, { signal })).json();

/** Sends JSON and gets JSON. */
export const postJson = async (path, body, signal) => (await post(path, body, 'application/json', signal)).json();

/** Gets a file's text. */
export const getText = async (path, signal) => (await call(path, { signal })).text();

/** Gets a file. */
export const getBlob = async (path, signal) => (await call(path, { signal })).blob();

/** The picture in a file with its own grey levels, as drawn ones are shown; a browser would change linear levels for the screen. */
export const bitmapOf = file => createImageBitmap(file, { colorSpaceConversion: 'none' });

/** Draws a frame into a file of a kind: image/png, application/fits, application/xml. */
export const renderFile = async (frame, kind, signal) => (await post('/v1/render', frame, kind, signal)).blob();

const ARRAYS = { u8: Uint8Array, u16: Uint16Array, i32: Int32Array, f32: Float32Array, f64: Float64Array };

/** Draws a frame, or the one layer that it names: {width, height, values}, row by row from the top. */
export async function renderPlane(frame, signal) {
    const answer = await post('/v1/render', frame, 'application/octet-stream', signal);
    const Values = ARRAYS[answer.headers.get('X-Msisf-Type')];
    return {
        width: Number(answer.headers.get('X-Msisf-Width')),
        height: Number(answer.headers.get('X-Msisf-Height')),
        values: new Values(await answer.arrayBuffer()),
    };
}

/** What the meta file of a frame says, as JSON. */
export const renderMeta = (frame, signal) => postJson('/v1/render', frame, signal);

/** What points of an image show: a list of readings, null where the Moon is not. */
export async function readPixels(frame, pixels, signal) {
    return (await postJson('/v1/pixels', { frame, pixels }, signal)).points;
}

/** Heights of the ground at [latitude, longitude] of a list, m. */
export const readGround = async (frame, points) => (await postJson('/v1/ground', { frame, points })).heights;

/** The light at places, hour by hour, over the month around a frame's time: {from, places}. Its horizons have no invented detail. */
export function readLight({ refine, 'refine-cell': cell, ...frame }, points) {
    return postJson('/v1/light', { frame, points });
}
