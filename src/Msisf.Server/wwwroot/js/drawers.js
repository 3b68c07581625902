// The panel that hides, and the buttons that open its drawers.

const $ = id => document.getElementById(id);

export class Drawers {
    /** @param onChange is called when the panel was shown or hidden. */
    constructor(onChange) {
        this.onChange = onChange;
        this.panel = $('panel');
        this.buttons = [...document.querySelectorAll('#rail [data-drawer]')];
        for (const button of this.buttons) {
            button.setAttribute('aria-expanded', 'false');
            button.setAttribute('aria-controls', `drawer-${button.dataset.drawer}`);
            button.addEventListener('click', () => this.toggle(button.dataset.drawer));
        }
        $('panel-close').addEventListener('click', () => this.hide());
        this.panel.addEventListener('toggle', () => this.#mark(), true);
        this.panel.addEventListener('keydown', event => {
            if (event.key === 'Escape') {
                this.hide();
                $('stage').focus();
            }
        });
    }

    /** Opens a drawer alone, or hides the panel if it is the one that is open. */
    toggle(name) {
        const drawer = $(`drawer-${name}`);
        const isShown = !this.panel.hidden && drawer.open;
        this.panel.hidden = isShown;
        for (const other of this.panel.querySelectorAll('details')) {
            other.open = !isShown && other === drawer;
        }
        this.#mark();
        if (!isShown) {
            drawer.scrollIntoView({ block: 'start' });
        }
    }

    /** Hides the panel, or shows it again with the drawers that were open. */
    switch() {
        if (this.panel.hidden && !this.panel.querySelector('details[open]')) {
            this.toggle('reading');
            return;
        }
        this.panel.hidden = !this.panel.hidden;
        this.#mark();
    }

    hide() {
        this.panel.hidden = true;
        this.#mark();
    }

    #mark() {
        for (const button of this.buttons) {
            const isOpen = !this.panel.hidden && $(`drawer-${button.dataset.drawer}`).open;
            button.setAttribute('aria-expanded', isOpen);
            button.setAttribute('aria-pressed', isOpen);
        }
        this.onChange();
    }
}
