// Whether the server is there: when it is lost, the page says so, and goes on when it is back.

const EVERY = 1000; // ms

export class Connection {
    #timer = 0;

    /** @param onLost gets words; @param onBack is called when the server answers again. */
    constructor(onLost, onBack) {
        Object.assign(this, { onLost, onBack });
    }

    /** The server did not answer. */
    lose() {
        this.onLost('The connection to msis is lost; trying again.');
        if (this.#timer === 0) {
            this.#timer = setInterval(() => this.#try(), EVERY);
        }
    }

    async #try() {
        const answer = await fetch('/healthz').catch(() => null);
        if (answer?.ok && this.#timer !== 0) {
            clearInterval(this.#timer);
            this.#timer = 0;
            this.onBack();
        }
    }
}
