// A time line of frames: a finished folder or a batch file of the server, the user's batch file, or a recorded flight.

import { Flight } from './flight.js';
import { viewOf } from './geometry.js';
import { metaRows } from './meta.js';
import { bitmapOf, getBlob, getJson, getText } from './server.js';
import { calendarOf } from './time.js';
import { keplerOf, openDropped, statesOf } from './trajectory.js';

const $ = id => document.getElementById(id);
const LEAST_TIME = 100; // ms that each frame is shown while playing

export class Frames {
    #list = [];
    #index = 0;
    #turn = 0;
    #isShowing = false;
    #isPlaying = false;

    /** @param offers answers the server's models. */
    constructor(state, picture, offers, onProblem) {
        Object.assign(this, { state, picture, offers, onProblem });
        this.flight = new Flight(state, states => this.open(this.#ofStates(states)), onProblem);
        $('folder').addEventListener('change', event => this.#try(this.#openFolder(event.target.value)));
        $('batch-file').addEventListener('change', event => event.target.files[0] && this.#try(this.#openFile(event.target.files[0])));
        openDropped(file => this.#try(this.#openFile(file)));
        $('kepler').addEventListener('change', event => event.target.value.trim() && this.#try(this.#openOrbit(event.target.value)));
        $('frame-slider').addEventListener('input', event => this.#try(this.show(event.target.valueAsNumber)));
        $('frame-first').addEventListener('click', () => this.#try(this.show(0)));
        $('frame-before').addEventListener('click', () => this.step(-1));
        $('frame-after').addEventListener('click', () => this.step(1));
        $('frame-play').addEventListener('click', () => this.togglePlay());
        $('frames-close').addEventListener('click', () => this.open([]));
        $('frame-kinds').addEventListener('change', () => this.#try(this.show(this.#index)));
    }

    /** Offers the server's folders and batch files. */
    async offer() {
        const { folders } = await getJson('/v1/folders').catch(() => ({ folders: [] }));
        $('folder').append(...folders.map(({ name, kind }) => new Option(kind === 'batch' ? `${name} (batch file)` : name, name)));
    }

    /** Puts frames on the time line and shows the first; none closes it. */
    open(list) {
        this.#list = list;
        this.#turn += 1;
        this.#stop();
        this.state.adopt(null);
        $('timeline').hidden = list.length === 0;
        $('frame-slider').max = Math.max(0, list.length - 1);
        $('frame-kinds').hidden = !list.some(frame => frame.image);
        $('meta').replaceChildren();
        if (list.length > 0) {
            this.#try(this.show(0));
        } else {
            $('folder').value = '';
            this.state.draw({});
        }
    }

    /** The states of the frames. */
    get states() {
        return this.#list.map(({ state }) => state);
    }

    /** Goes frames on or back. */
    step(count) {
        if (this.#list.length > 0) {
            this.#stop();
            this.#try(this.show(this.#index + count));
        }
    }

    togglePlay() {
        if (this.#isPlaying) {
            this.#stop();
        } else if (this.#list.length > 0) {
            this.#isPlaying = true;
            this.#showPlaying();
            this.#try(this.#play());
        }
    }

    /** The camera was moved: by a frame, or by hand, which ends playing. */
    onView() {
        if (!this.#isShowing) {
            this.#stop();
        }
        this.flight.note();
    }

    /** Shows a frame: its stored image or annotated image, or draws it anew with its own options. One that comes late is left out. */
    async show(index) {
        const turn = ++this.#turn;
        this.#index = Math.min(Math.max(index, 0), this.#list.length - 1);
        const frame = this.#list[this.#index];
        const kind = document.querySelector('input[name="frame-kind"]:checked').value;
        const url = kind === 'drawn' ? null : frame[kind] ?? frame.image;
        $('frame-slider').value = this.#index;
        const time = calendarOf(frame.state[0]).replace('T', ' ');
        $('frame-label').textContent = `${frame.number} of ${this.#list.at(-1).number}, ${time} UTC`;
        $('frame-slider').setAttribute('aria-valuetext', $('frame-label').textContent);
        const bitmap = url ? await bitmapOf(await getBlob(url)) : null;
        if (turn !== this.#turn) {
            return;
        }
        if (frame.meta) {
            this.state.adopt(this.#offered(frame));
        }
        this.#isShowing = true;
        this.state.look(viewOf(frame.state), bitmap !== null);
        this.#isShowing = false;
        if (bitmap) {
            const whole = { ...this.state.frame(this.state.size, frame.options.samples), 'fixed-state': frame.state };
            this.picture.showStored(bitmap, whole, `Stored ${kind === 'annotated' ? 'annotated image' : 'image'} of frame ${frame.number}: `
                + `${bitmap.width} × ${bitmap.height}.`);
        }
        await this.#showMeta(frame, turn);
    }

    /** A frame's options with the name of its model, as the page's choices have it, and with the size of its camera. */
    #offered({ options: { res, ...options }, camera }) {
        const { models } = this.offers();
        const model = models.find(({ whole_moon: whole, pixels_per_degree: resolution }) => whole && resolution === res);
        return {
            ...options,
            ...(model ? { model: model.name } : res !== undefined && { res }),
            ...(camera && { width: camera.width, height: camera.height, fov: camera.field_of_view }),
        };
    }

    async #play() {
        for (let index = this.#index; this.#isPlaying; index = this.#index + 1) {
            const pause = new Promise(resolve => setTimeout(resolve, LEAST_TIME));
            await this.show(index >= this.#list.length ? 0 : index);
            await pause;
        }
    }

    async #openFolder(name) {
        this.open(name ? (await getJson(`/v1/folders/${encodeURIComponent(name)}`)).frames : []);
    }

    async #openFile(file) {
        this.open(this.#ofStates(await statesOf(file.name, await file.text(), this.state.view.mjd)));
    }

    async #openOrbit(text) {
        if (!keplerOf(text)) {
            throw new Error('An orbit is six numbers in braces, {a, e, ω, Ω, i, M₀}: a in m and above 0, angles in rad.');
        }
        this.open(this.#ofStates(await statesOf('The orbit', text, this.state.view.mjd)));
    }

    #ofStates(states) {
        return states.map((state, index) => ({ number: index + 1, state }));
    }

    async #showMeta(frame, turn) {
        if (!frame.meta || this.#isPlaying) {
            return;
        }
        const rows = metaRows(await getText(frame.meta));
        if (turn !== this.#turn) {
            return;
        }
        $('meta').replaceChildren(...rows.map(([name, value]) => {
            const row = document.createElement('div');
            const [term, description] = [document.createElement('dt'), document.createElement('dd')];
            term.textContent = name;
            description.textContent = value;
            row.append(term, description);
            return row;
        }));
    }

    #stop() {
        this.#isPlaying = false;
        this.#showPlaying();
    }

    #showPlaying() {
        $('frame-play').setAttribute('aria-pressed', this.#isPlaying);
        $('frame-play').textContent = this.#isPlaying ? 'Stop' : 'Play';
    }

    #try(promise) {
        promise.catch(error => {
            this.#stop();
            this.onProblem(error.message);
        });
    }
}
