// The picture on the screen: canvases of one size over each other, and where in the image the mouse is.

export class Stage {
    /** @param onRoom gets the room for the picture in px of the screen when it changes. */
    constructor(stage, picture, onRoom) {
        this.stage = stage;
        this.picture = picture;
        this.image = picture.querySelector('#image');
        this.warp = picture.querySelector('#warp');
        this.layer = picture.querySelector('#layer');
        this.other = picture.querySelector('#other');
        this.overlay = picture.querySelector('#overlay');
        this.size = { width: 1, height: 1 };
        /** What lies over the picture; hidden ones have no size. */
        this.boxes = [...document.querySelectorAll('#search, #notice, #corner > *, #ground > *, #panel')];
        const covering = new ResizeObserver(() => this.onPlaced?.());
        this.boxes.forEach(box => covering.observe(box));
        new ResizeObserver(() => {
            this.place();
            const pixels = this.pixelRatio;
            onRoom(Math.max(1, Math.floor(stage.clientWidth * pixels)), Math.max(1, Math.floor(stage.clientHeight * pixels)));
        }).observe(stage);
    }

    /** Pixels of the screen in one of the page. */
    get pixelRatio() {
        return window.devicePixelRatio || 1;
    }

    /** The size of the image at rest, by which pixels are counted. */
    setSize(size) {
        if (size.width !== this.size.width || size.height !== this.size.height) {
            this.size = size;
            this.place();
        }
    }

    /** Gives the picture the largest place in the stage that has its shape. */
    place() {
        const { width, height } = this.size;
        const factor = Math.min(this.stage.clientWidth / width, this.stage.clientHeight / height);
        this.picture.style.width = `${width * factor}px`;
        this.picture.style.height = `${height * factor}px`;
        this.overlay.width = Math.max(1, Math.round(width * factor * this.pixelRatio));
        this.overlay.height = Math.max(1, Math.round(height * factor * this.pixelRatio));
        this.onPlaced?.();
    }

    /** Shows grey values, row by row from the top, on a canvas. */
    static paintGrey(canvas, { width, height, values }) {
        const pixels = new ImageData(width, height);
        const words = new Uint32Array(pixels.data.buffer);
        const shift = values instanceof Uint16Array ? 8 : 0;
        for (let i = 0; i < words.length; i++) {
            words[i] = 0xff000000 | (values[i] >> shift) * 0x010101;
        }
        Stage.paint(canvas, pixels);
    }

    /** Shows a picture of any size. */
    showPicture(canvas, bitmap) {
        canvas.width = bitmap.width;
        canvas.height = bitmap.height;
        canvas.getContext('2d').drawImage(bitmap, 0, 0);
    }

    static paint(canvas, pixels) {
        if (canvas.width !== pixels.width || canvas.height !== pixels.height) {
            canvas.width = pixels.width;
            canvas.height = pixels.height;
        }
        canvas.getContext('2d').putImageData(pixels, 0, 0);
    }

    /** The pixel at a place of the page, the first being 1, 1; null beside the picture. */
    pixelAt(clientX, clientY) {
        const box = this.picture.getBoundingClientRect();
        const x = Math.floor((clientX - box.left) / box.width * this.size.width) + 1;
        const y = Math.floor((clientY - box.top) / box.height * this.size.height) + 1;
        return x >= 1 && y >= 1 && x <= this.size.width && y <= this.size.height ? [x, y] : null;
    }

    /** Where boxes of the page lie over the picture, [left, top, right, bottom] of each, px of the overlay. */
    get covered() {
        const { left, top, width } = this.picture.getBoundingClientRect();
        const unit = this.overlay.width / Math.max(1, width);
        return this.boxes.map(box => box.getBoundingClientRect()).filter(box => box.width > 0)
            .map(box => [(box.left - left) * unit, (box.top - top) * unit, (box.right - left) * unit, (box.bottom - top) * unit]);
    }

    /** Where a point of the overlay is in the page. */
    onPage([x, y]) {
        const { left, top, width } = this.picture.getBoundingClientRect();
        const unit = this.overlay.width / Math.max(1, width);
        return [left + x / unit, top + y / unit];
    }

    /** Where the middle of a pixel is in the stage, px of the page. */
    placeOf([x, y]) {
        const unit = this.picture.clientWidth / this.size.width;
        return [this.picture.offsetLeft + (x - 0.5) * unit, this.picture.offsetTop + (y - 0.5) * unit];
    }

    /** Pixels of the image in one of the page. */
    get imagePixelsPerPagePixel() {
        return this.size.width / Math.max(1, this.picture.clientWidth);
    }
}
