// The page's address: it holds what is looked at and what is marked, so that a reload or a bookmark brings it back.
// The pins, whose readings are long, are kept beside it: a reload has them, a bookmark has not.

const $ = id => document.getElementById(id);

/** Fields that the address holds by these names: what is shown over the picture. */
const FIELDS = {
    layer: 'layer-choice', opacity: 'layer-opacity', craters: 'catalogue', landmarks: 'landmarks',
    grid: 'show-grid', terminator: 'show-terminator', arrow: 'show-arrow',
};

const LONGEST = 40; // letters of a value that cannot be used, in a message

const valueOf = field => (field.type === 'checkbox' ? String(field.checked) : field.value);

const firstValueOf = field => (field.type === 'checkbox' ? String(field.defaultChecked)
    : field.type === 'range' ? field.defaultValue : field.options[0].value);

function put(field, value) {
    if (field.type === 'checkbox') {
        field.checked = value === 'true';
    } else {
        field.value = value;
    }
    return valueOf(field) === value;
}

/** Sets a field as a hand does; what it does not take makes it as at first. Answers whether it took the value. */
function set(field, value) {
    const isTaken = put(field, value) || !put(field, firstValueOf(field));
    field.dispatchEvent(new Event(field.type === 'range' ? 'input' : 'change'));
    return isTaken;
}

export class Address {
    #isRead = false;

    constructor(state, readings) {
        Object.assign(this, { state, readings });
        for (const id of Object.values(FIELDS)) {
            $(id).addEventListener('change', () => this.write());
        }
    }

    /** Writes it anew; not before it was read. */
    write() {
        if (!this.#isRead) {
            return;
        }
        const parameters = new URLSearchParams(this.state.toText());
        for (const [name, id] of Object.entries(FIELDS)) {
            if (valueOf($(id)) !== firstValueOf($(id))) {
                parameters.set(name, valueOf($(id)));
            }
        }
        history.replaceState({ pins: this.readings.pins }, '', `#${parameters}`);
    }

    /** Takes over what was written, once the fields have their choices. @returns words about what cannot be used; null if all can. */
    read(models) {
        this.#isRead = false;
        const parameters = new URLSearchParams(location.hash.slice(1));
        const unused = [];
        for (const [name, id] of Object.entries(FIELDS)) {
            if (!set($(id), parameters.get(name) ?? firstValueOf($(id)))) {
                unused.push([name, parameters.get(name)]);
            }
            parameters.delete(name);
        }
        this.readings.pins = history.state?.pins ?? this.readings.pins;
        unused.push(...this.state.fromText(parameters, models));
        this.#isRead = true;
        const words = unused.map(([name, value]) => `${name}=${value}`.slice(0, LONGEST));
        return words.length > 0 ? `The page cannot use this of its address, and shows what it has without it: ${words.join(', ')}.` : null;
    }
}
