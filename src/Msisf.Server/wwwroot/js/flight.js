// A flight: the states that the camera was in while it was recorded.

import { writeBatch } from './batch.js';
import { stateOf } from './geometry.js';
import { save } from './takeaway.js';
import { recordVideo } from './video.js';

const $ = id => document.getElementById(id);
const BETWEEN = 100; // ms between two states, so that playing takes as long as flying
const MOST_STATES = 6000;

export class Flight {
    #states = [];
    #isRecording = false;
    #last = 0;
    #timer = 0;

    /** @param onRecorded gets the states of a flight when it ends. */
    constructor(state, onRecorded, onProblem) {
        Object.assign(this, { state, onRecorded, onProblem });
        $('record').addEventListener('click', () => (this.#isRecording ? this.#end() : this.#begin()));
        $('flight-save').addEventListener('click', () => save(new Blob([writeBatch(this.#states)], { type: 'text/plain' }), 'flight.tab'));
        $('flight-video').addEventListener('click', event => this.#saveVideo(event.target));
    }

    /** Keeps the state of the view if it is a new one and a flight is recorded; not before the last one is long enough ago. */
    note() {
        clearTimeout(this.#timer);
        const wait = this.#last + BETWEEN - performance.now();
        if (this.#isRecording && wait > 0) {
            this.#timer = setTimeout(() => this.note(), wait);
        } else if (this.#isRecording) {
            this.#keep();
            if (this.#states.length === MOST_STATES) {
                this.#end();
            }
        }
    }

    #keep() {
        const state = stateOf(this.state.view);
        if (this.#states.at(-1)?.every((number, index) => number === state[index])) {
            return;
        }
        this.#last = performance.now();
        this.#states.push(state);
        $('record').textContent = `Stop recording (${this.#states.length})`;
    }

    #begin() {
        this.#isRecording = true;
        this.#states = [];
        this.#last = -BETWEEN;
        $('record').setAttribute('aria-pressed', 'true');
        this.note();
    }

    #end() {
        this.#keep();
        this.#isRecording = false;
        $('record').setAttribute('aria-pressed', 'false');
        $('record').textContent = 'Record a flight';
        $('flight-save').disabled = false;
        $('flight-video').disabled = !('MediaRecorder' in window);
        this.onRecorded(this.#states);
    }

    async #saveVideo(button) {
        button.disabled = true;
        try {
            const frames = this.#states.map(state => ({ ...this.state.frame(this.state.movingSize), 'fixed-state': state }));
            save(await recordVideo(frames, 1000 / BETWEEN, words => button.textContent = words), 'flight.webm');
        } catch (error) {
            this.onProblem(error.message);
        } finally {
            button.textContent = 'Save as video';
            button.disabled = false;
        }
    }
}
