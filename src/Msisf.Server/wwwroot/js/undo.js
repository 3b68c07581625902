// The views before this one, to go back to.

const MOST = 100;

export class Undo {
    #views = [];

    constructor(state, button) {
        Object.assign(this, { state, button });
        button.addEventListener('click', () => this.back());
    }

    /** Keeps what is looked at, when the picture is at rest. */
    keep() {
        const { view, picture } = this.state;
        const last = this.#views.at(-1);
        const now = JSON.stringify({ view, picture });
        if (now !== last) {
            this.#views = [...this.#views.slice(1 - MOST), now];
        }
        this.button.disabled = this.#views.length < 2;
    }

    /** Goes to the view before. */
    back() {
        const now = JSON.stringify({ view: this.state.view, picture: this.state.picture });
        if (this.#views.at(-1) === now) {
            this.#views.pop();
        }
        const before = this.#views.pop();
        if (before) {
            const { view, picture } = JSON.parse(before);
            this.state.picture = picture;
            this.state.look(view);
        }
        this.button.disabled = this.#views.length < 1;
    }
}
