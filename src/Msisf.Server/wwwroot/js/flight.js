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

    /** @param onRecorded gets the states of a flight when it ends. */
    constructor(state, onRecorded, onProblem) {
        Object.assign(this, { state, onRecorded, onProblem });
        $('record').addEventListener('click', () => (this.#isRecording ? this.#end() : this.#begin()));
        $('flight-save').addEventListener('click', () => save(new Blob([writeBatch(this.#states)], { type: 'text/plain' }), 'flight.tab'));
        $('flight-video').addEventListener('click', event => this.#saveVideo(event.target));
    }

    /** Keeps the state of the view, if a flight is recorded and the last one is long enough ago. */
    note() {
        const now = performance.now();
        if (this.#isRecording && now - this.#last >= BETWEEN) {
            this.#last = now;
            this.#states.push(stateOf(this.state.view));
            $('record').textContent = `Stop recording (${this.#states.length})`;
            if (this.#states.length === MOST_STATES) {
                this.#end();
            }
        }
    }

    #begin() {
        this.#isRecording = true;
        this.#states = [];
        this.#last = 0;
        $('record').setAttribute('aria-pressed', 'true');
        this.note();
    }

    #end() {
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
