// The images of a moving camera, by WebSocket: one is drawn at a time, and of the states that come meanwhile only the newest.

const PAUSE = 150; // ms between two images with their depth: between them the page draws by itself, for which it needs the processor
const MAGIC = 0x4649534d; // "MSIF", little-endian

export class ImageStream {
    /**
     * @param onImage gets {number, width, height, values} of each image, its depth alike or null, and the milliseconds that it took.
     * @param onProblem gets the server's words when a state cannot be drawn; null when all is well again.
     * @param onLost is called when the connection is lost.
     */
    constructor(onImage, onProblem, onLost) {
        this.onImage = onImage;
        this.onProblem = onProblem;
        this.onLost = onLost;
        this.number = 0;
        this.next = null;
        this.isDrawing = false;
        this.isReady = false;
        this.isRefused = false;
        this.key = null;
    }

    /** Asks for the image of a frame; one that is not begun yet is dropped. */
    show(frame) {
        this.next = frame;
        const key = ImageStream.#fixedPart(frame);
        if (this.socket?.readyState === WebSocket.CONNECTING) {
            [this.key, this.opening] = [key, frame]; // it has not said yet what it is for
        } else if (!this.socket || this.key !== key) {
            this.#open(frame, key);
        } else {
            this.#send();
        }
    }

    /** Forgets what is not begun yet. */
    rest() {
        this.next = null;
    }

    /** All of a frame but what each state brings: a change of it needs another connection. */
    static #fixedPart(frame) {
        return JSON.stringify({ ...frame, 'fixed-state': null, fov: null });
    }

    #open(frame, key) {
        this.socket?.close();
        [this.key, this.opening] = [key, frame];
        this.isReady = false;
        this.isRefused = false;
        this.isDrawing = false;
        const socket = new WebSocket(`${location.protocol === 'https:' ? 'wss' : 'ws'}://${location.host}/v1/stream`);
        socket.binaryType = 'arraybuffer';
        socket.onopen = () => socket.send(JSON.stringify({
            frame: this.opening, mode: 'newest-only', format: this.opening.layers ? 'u8+layers' : 'u8',
        }));
        socket.onmessage = event => this.socket === socket && this.#receive(event.data);
        socket.onclose = event => this.socket === socket && this.#lost(event);
        this.socket = socket;
    }

    #receive(data) {
        if (typeof data === 'string') {
            const answer = JSON.parse(data);
            this.isReady ||= answer.ready === true;
            const words = answer.error ?? answer.detail;
            if (words !== undefined) {
                this.isDrawing = false;
                this.isRefused = !this.isReady;
                this.onProblem(words);
            }
        } else {
            const header = new DataView(data);
            if (header.getUint32(0, true) !== MAGIC) {
                return;
            }
            this.isDrawing = false;
            this.onProblem(null);
            const [number, width, height] = [4, 8, 12].map(place => header.getUint32(place, true));
            const end = 16 + width * height;
            const image = { number, width, height, values: new Uint8Array(data, 16, width * height) };
            const depth = data.byteLength > end ? { width, height, values: new Float32Array(data.slice(end)) } : null;
            this.onImage(image, depth, performance.now() - this.sentAt);
        }
        this.#send();
    }

    #send() {
        if (!this.isReady || this.isDrawing || !this.next || this.socket.readyState !== WebSocket.OPEN) {
            return;
        }
        const wait = this.next.layers && this.sentAt ? this.sentAt + PAUSE - performance.now() : 0;
        if (wait > 0) {
            clearTimeout(this.timer);
            this.timer = setTimeout(() => this.#send(), wait);
            return;
        }
        const { 'fixed-state': state, fov } = this.next; // fov is left out where a camera has it
        this.drawn = this.next;
        this.next = null;
        this.isDrawing = true;
        this.sentAt = performance.now();
        this.number += 1;
        this.socket.send(JSON.stringify({ number: this.number, 'fixed-state': state, fov }));
    }

    #lost(event) {
        this.socket = null;
        this.key = null;
        if (this.isRefused) {
            this.next = null; // the server has said why; it would say it again
            return;
        }
        if (event.reason) {
            this.onProblem(event.reason);
        }
        this.onLost();
    }
}
