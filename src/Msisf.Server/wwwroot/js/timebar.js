// The bar below the picture: time, play and rates, and the Sun's elevation at the middle of the picture along half a month each way.

import { sunAt } from './geometry.js';
import { centreOf } from './models.js';
import { getJson } from './server.js';
import { degrees, windOf } from './text.js';
import { calendarOf, mjdOf } from './time.js';

const $ = id => document.getElementById(id);

const HALF = 15; // days on each side
const LEAST_HEIGHT = 5; // degrees, of the bar's half height: at a pole the Sun stays low
const COUNT = 361; // times of the Sun: every two hours
const COLOURS = { ground: '#0b0f16', night: '#141d33', day: '#3a2f1b', line: '#ffc46b', horizon: '#4a5670', text: '#aab4c6' };

export class TimeBar {
    #anchor;
    #path = null;
    #asked = null;
    #lastTime = 0;
    #isTyping = false;

    constructor(state) {
        this.state = state;
        this.#anchor = state.view.mjd;
        this.isPlaying = false;
        $('calendar').addEventListener('input', () => this.#isTyping = true);
        $('calendar').addEventListener('blur', () => {
            this.#isTyping = false;
            this.show();
        });
        $('calendar').addEventListener('change', event => {
            this.#isTyping = false;
            const mjd = mjdOf(event.target.value.trim().replace(' ', 'T'));
            if (mjd !== null) {
                state.look({ mjd });
                this.anchor();
            } else {
                this.show();
            }
        });
        $('time-slider').addEventListener('input', event => state.look({ mjd: this.#anchor + event.target.valueAsNumber }));
        $('time-steps').addEventListener('click', event => event.target.dataset.days && this.step(Number(event.target.dataset.days)));
        $('time-play').addEventListener('click', () => this.togglePlay());
        new ResizeObserver(() => this.#draw()).observe($('strip'));
    }

    step(days) {
        this.state.look({ mjd: this.state.view.mjd + days });
        if (Math.abs(this.state.view.mjd - this.#anchor) > HALF) {
            this.anchor();
        }
    }

    /** Makes the time the middle of the bar. */
    anchor() {
        this.#anchor = this.state.view.mjd;
        this.show();
    }

    stop() {
        if (this.isPlaying) {
            this.togglePlay();
        }
    }

    togglePlay() {
        this.isPlaying = !this.isPlaying;
        $('time-play').setAttribute('aria-pressed', this.isPlaying);
        $('time-play').textContent = this.isPlaying ? '❚❚' : '▶';
        this.#lastTime = performance.now();
        if (this.isPlaying) {
            requestAnimationFrame(time => this.#run(time));
        }
    }

    #run(time) {
        if (this.isPlaying) {
            const seconds = Math.min(Math.max(time - this.#lastTime, 0) / 1000, 0.25);
            this.#lastTime = time;
            this.step(seconds * Number($('time-rate').value) / 86400);
            requestAnimationFrame(next => this.#run(next));
        }
    }

    /** Writes the time; the text that is being typed is left alone. */
    show() {
        const { mjd } = this.state.view;
        if (Math.abs(mjd - this.#anchor) > HALF + 0.01) {
            this.#anchor = mjd;
        }
        if (!this.#isTyping) {
            $('calendar').value = `${calendarOf(mjd)}Z`;
        }
        $('time-slider').value = mjd - this.#anchor;
        $('time-slider').setAttribute('aria-valuetext', `${calendarOf(mjd)}Z`);
        this.#ask();
    }

    /** Says how the Sun stands at the middle of the picture; null beside the Moon. */
    say(sun) {
        $('sun-said').textContent = sun
            ? `Sun ${degrees(sun.elevation, 1)}${sun.azimuth === null ? '' : ` ${windOf(sun.azimuth)}`} at the centre` : '';
        $('sun-said').toggleAttribute('data-night', Boolean(sun && sun.elevation < 0));
        this.#draw();
    }

    async #ask() {
        if (this.#asked === this.#anchor) {
            return;
        }
        this.#asked = this.#anchor;
        const [from, to] = [this.#asked - HALF, this.#asked + HALF];
        const path = await getJson(`/v1/sun/path?from=${from}&to=${to}&count=${COUNT}`).catch(() => null);
        if (path?.from === this.#anchor - HALF) {
            this.#path = path;
            this.#draw();
        }
    }

    #draw() {
        const canvas = $('time-strip');
        const ratio = window.devicePixelRatio || 1;
        const [width, height] = [Math.round(canvas.clientWidth * ratio), Math.round(canvas.clientHeight * ratio)];
        if (width === 0) {
            return;
        }
        [canvas.width, canvas.height] = [width, height];
        const pen = canvas.getContext('2d');
        pen.fillStyle = COLOURS.ground;
        pen.fillRect(0, 0, width, height);
        const centre = centreOf(this.state.view, this.state.size);
        const text = 0.875 * parseFloat(getComputedStyle(document.documentElement).fontSize) * ratio;
        const low = height - text * 1.25;
        const elevations = centre && this.#path ? this.#path.positions.map(position => sunAt(centre, position).elevation) : [];
        const most = elevations.reduce((all, elevation) => Math.max(all, Math.abs(elevation)), LEAST_HEIGHT);
        const at = elevation => low / 2 - elevation / most * (low / 2 - 2 * ratio);
        if (elevations.length > 0) {
            const heights = elevations.map(at);
            const x = index => index / (COUNT - 1) * width;
            const curve = () => {
                pen.beginPath();
                heights.forEach((y, index) => pen[index ? 'lineTo' : 'moveTo'](x(index), y));
            };
            for (const [colour, top, bottom] of [[COLOURS.day, 0, at(0)], [COLOURS.night, at(0), low]]) {
                pen.save();
                pen.beginPath();
                pen.rect(0, top, width, bottom - top);
                pen.clip();
                curve();
                pen.lineTo(width, at(0));
                pen.lineTo(0, at(0));
                pen.fillStyle = colour;
                pen.fill();
                pen.restore();
            }
            curve();
            pen.strokeStyle = COLOURS.line;
            pen.lineWidth = 1.5 * ratio;
            pen.stroke();
        }
        pen.fillStyle = COLOURS.horizon;
        pen.fillRect(0, at(0), width, ratio);
        this.#days(pen, width, height, text, ratio);
    }

    #days(pen, width, height, text, ratio) {
        pen.font = `${text}px system-ui, sans-serif`;
        pen.textBaseline = 'alphabetic';
        const every = [1, 2, 5, 10, 15].find(days => days / (2 * HALF) * width > text * 6.5) ?? 30;
        for (let day = Math.ceil((this.#anchor - HALF) / every) * every; day < this.#anchor + HALF; day += every) {
            const x = (day - this.#anchor + HALF) / (2 * HALF) * width;
            pen.fillStyle = COLOURS.horizon;
            pen.fillRect(x, height - text * 1.2, ratio, text * 1.2);
            pen.fillStyle = COLOURS.text;
            if (x + 5.2 * text < width) {
                pen.fillText(calendarOf(day).slice(0, 10), x + text * 0.3, height - text * 0.2);
            }
        }
    }
}
