// A video of frames, coded by the browser itself (WebM).

import { renderPlane } from './server.js';
import { Stage } from './stage.js';

/**
 * Draws frames and records them.
 * @param frames as the server takes them, of one size; @param rate frames a second.
 * @param onProgress gets a few words.
 */
export async function recordVideo(frames, rate, onProgress) {
    const pictures = [];
    for (const frame of frames) {
        onProgress(`Drawing ${pictures.length + 1} of ${frames.length}`);
        pictures.push(await renderPlane(frame));
    }
    const canvas = document.createElement('canvas');
    Stage.paintGrey(canvas, pictures[0]);
    const track = canvas.captureStream(0);
    const recorder = new MediaRecorder(track, { mimeType: 'video/webm', videoBitsPerSecond: 8e6 });
    const parts = [];
    recorder.ondataavailable = event => parts.push(event.data);
    const ended = new Promise(resolve => recorder.onstop = resolve);
    recorder.start();
    for (const [index, picture] of pictures.entries()) {
        onProgress(`Recording ${index + 1} of ${pictures.length}`);
        const pause = new Promise(resolve => setTimeout(resolve, 1000 / rate));
        Stage.paintGrey(canvas, picture);
        track.getVideoTracks()[0].requestFrame();
        await pause;
    }
    recorder.stop();
    await ended;
    return new Blob(parts, { type: 'video/webm' });
}
