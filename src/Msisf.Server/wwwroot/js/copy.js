// Copies a text to the clipboard.

const $ = id => document.getElementById(id);

/** Copies a text. Where the browser forbids it (as it does for pages of other computers without https), the text stands selected. */
export async function copy(text) {
    $('copied').value = text;
    try {
        await navigator.clipboard.writeText(text);
        $('status').textContent = 'Copied.';
    } catch {
        $('copied').closest('details').open = true;
        $('copied').select();
        $('status').textContent = 'The browser forbids copying. The text is selected: press Ctrl-C.';
    }
}
