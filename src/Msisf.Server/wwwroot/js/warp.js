// The last exact image as it looks from another place: a mesh of its depth, with the image on it. What it does not show is left open.

import { cameraOf, circleAround, dot, focalLength, limbAngle, normalize, scale, subtract, REFERENCE_RADIUS } from './geometry.js';

/** Lengths in m, axes of a camera: x right, y up, z forward. What is open is clear, so that the page shows through. */
const VERTEX = `#version 300 es
uniform mat3 turn;    // into the axes of the camera
uniform vec3 eye;     // the camera
uniform vec3 lens;    // focal length in half widths and half heights; distance of the near plane
in vec3 point;
in vec2 place;
out vec2 uv;
void main() {
    vec3 seen = turn * (point - eye);
    gl_Position = vec4(seen.xy * lens.xy, seen.z - 2.0 * lens.z, seen.z);
    uv = place;
}`;

const FRAGMENT = `#version 300 es
precision mediump float;
uniform sampler2D image;
uniform bool isOpen;
in vec2 uv;
out vec4 colour;
void main() { colour = isOpen ? vec4(0) : vec4(vec3(texture(image, uv).r), 1); }`;

const COLUMNS = 112;
const TORN = 1.5; // times as deep as its neighbour: not the same ground
const LIMB_POINTS = 128;
const IDENTITY = [1, 0, 0, 0, 1, 0, 0, 0, 1];

/** The grey levels of an image in eight bits. */
const levelsOf = ({ values }) => (values instanceof Uint16Array ? Uint8Array.from(values, value => value >> 8) : values);

/**
 * The mesh of a depth map: five numbers of each vertex (point; place in the image), and three vertices of each triangle. The sky beside
 * ground lies as deep as that, so that the limb is whole; other sky has no triangles. Pure.
 */
export function meshOf({ width, height, values }, fov) {
    const rows = Math.max(1, Math.round(COLUMNS * height / width));
    const across = COLUMNS + 1;
    const at = (column, row) => values[Math.min(Math.floor(row / rows * height), height - 1) * width
        + Math.min(Math.floor(column / COLUMNS * width), width - 1)];
    const found = Float64Array.from({ length: across * (rows + 1) }, (_, i) => Math.max(at(i % across, Math.floor(i / across)), 0) || 0);
    const depths = found.map((depth, i) => {
        if (depth > 0) {
            return depth;
        }
        const [column, row] = [i % across, Math.floor(i / across)];
        let [sum, count] = [0, 0];
        for (let y = Math.max(row - 1, 0); y <= Math.min(row + 1, rows); y++) {
            for (let x = Math.max(column - 1, 0); x <= Math.min(column + 1, COLUMNS); x++) {
                if (found[y * across + x] > 0) {
                    sum += found[y * across + x];
                    count += 1;
                }
            }
        }
        return count > 0 ? sum / count : 0;
    });
    const focal = focalLength(1, fov);
    const vertices = new Float32Array(5 * depths.length);
    depths.forEach((depth, i) => {
        const [u, v] = [i % across / COLUMNS, Math.floor(i / across) / rows];
        vertices.set([(u - 0.5) / focal * depth, (0.5 - v) * height / width / focal * depth, depth, u, v], 5 * i);
    });
    const triangles = [];
    for (let row = 0; row < rows; row++) {
        for (let column = 0; column < COLUMNS; column++) {
            const a = row * across + column;
            const corners = [a, a + 1, a + across, a + across + 1];
            const [least, most] = [Math.min(...corners.map(i => depths[i])), Math.max(...corners.map(i => depths[i]))];
            if (least > 0 && most < TORN * least) {
                triangles.push(a, a + across, a + 1, a + 1, a + across, a + across + 1);
            }
        }
    }
    return { vertices, triangles: new Uint32Array(triangles), nearest: depths.reduce((all, d) => (d > 0 && d < all ? d : all), Infinity) };
}

export class Warp {
    #gl;
    #at;
    #buffers;
    #source = null;

    /** @param onLost is called when the browser takes the graphics away. */
    constructor(canvas, onLost) {
        this.canvas = canvas;
        this.#gl = canvas.getContext('webgl2', { antialias: false });
        if (!this.#gl) {
            return;
        }
        canvas.addEventListener('webglcontextlost', event => {
            event.preventDefault();
            this.#source = null;
            this.isReady = false;
            onLost();
        });
        canvas.addEventListener('webglcontextrestored', () => this.#prepare());
        this.#prepare();
    }

    #prepare() {
        const gl = this.#gl;
        const program = gl.createProgram();
        for (const [kind, text] of [[gl.VERTEX_SHADER, VERTEX], [gl.FRAGMENT_SHADER, FRAGMENT]]) {
            const shader = gl.createShader(kind);
            gl.shaderSource(shader, text);
            gl.compileShader(shader);
            gl.attachShader(program, shader);
        }
        gl.bindAttribLocation(program, 0, 'point');
        gl.bindAttribLocation(program, 1, 'place');
        gl.linkProgram(program);
        if (!gl.getProgramParameter(program, gl.LINK_STATUS)) {
            console.warn(gl.getProgramInfoLog(program)); // pictures come as without WebGL2
            return;
        }
        gl.useProgram(program);
        this.#at = Object.fromEntries(['turn', 'eye', 'lens', 'isOpen'].map(name => [name, gl.getUniformLocation(program, name)]));
        gl.bindTexture(gl.TEXTURE_2D, gl.createTexture());
        for (const [name, value] of [[gl.TEXTURE_MIN_FILTER, gl.LINEAR], [gl.TEXTURE_MAG_FILTER, gl.LINEAR],
            [gl.TEXTURE_WRAP_S, gl.CLAMP_TO_EDGE], [gl.TEXTURE_WRAP_T, gl.CLAMP_TO_EDGE]]) {
            gl.texParameteri(gl.TEXTURE_2D, name, value);
        }
        gl.pixelStorei(gl.UNPACK_ALIGNMENT, 1);
        this.#buffers = { mesh: gl.createBuffer(), triangles: gl.createBuffer(), limb: gl.createBuffer() };
        gl.enableVertexAttribArray(0);
        this.isReady = true;
    }

    /** Whether there is an image to start from. */
    get hasSource() {
        return this.#source !== null;
    }

    /** Starts from an image and its depth, which may have fewer pixels; both of a view. */
    take(image, depth, view) {
        if (!this.isReady || this.#gl.isContextLost()) {
            return;
        }
        const gl = this.#gl;
        const { vertices, triangles, nearest } = meshOf(depth, view.fov);
        gl.texImage2D(gl.TEXTURE_2D, 0, gl.R8, image.width, image.height, 0, gl.RED, gl.UNSIGNED_BYTE, levelsOf(image));
        gl.bindBuffer(gl.ARRAY_BUFFER, this.#buffers.mesh);
        gl.bufferData(gl.ARRAY_BUFFER, vertices, gl.STATIC_DRAW);
        gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, this.#buffers.triangles);
        gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, triangles, gl.STATIC_DRAW);
        this.#source = { camera: cameraOf(view), count: triangles.length, nearest };
    }

    /** Forgets the image. */
    drop() {
        this.#source = null;
    }

    /** Draws the picture of a view into the canvas, whose size is that of the picture. */
    draw(view, { width, height }) {
        const [gl, source, camera] = [this.#gl, this.#source, cameraOf(view)];
        if (this.canvas.width !== width || this.canvas.height !== height) {
            [this.canvas.width, this.canvas.height] = [width, height];
        }
        const axes = [source.camera.right, source.camera.up, source.camera.forward];
        const way = subtract(camera.position, source.camera.position);
        const focal = focalLength(2, view.fov);
        gl.viewport(0, 0, width, height);
        gl.clearColor(0, 0, 0, 1); // the sky
        gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
        gl.uniform3f(this.#at.lens, focal, focal * width / height, Math.max(0.02 * source.nearest, 0.1));
        this.#open(camera);
        gl.enable(gl.DEPTH_TEST);
        const turn = axes.flatMap(axis => [camera.right, camera.up, camera.forward].map(other => dot(axis, other)));
        gl.uniformMatrix3fv(this.#at.turn, false, turn);
        gl.uniform3fv(this.#at.eye, axes.map(axis => dot(axis, way)));
        gl.uniform1i(this.#at.isOpen, 0);
        gl.bindBuffer(gl.ARRAY_BUFFER, this.#buffers.mesh);
        gl.vertexAttribPointer(0, 3, gl.FLOAT, false, 20, 0);
        gl.enableVertexAttribArray(1);
        gl.vertexAttribPointer(1, 2, gl.FLOAT, false, 20, 12);
        gl.drawElements(gl.TRIANGLES, source.count, gl.UNSIGNED_INT, 0);
    }

    /** Leaves the Moon's disc open, for the mesh to cover what it knows of it. */
    #open(camera) {
        const gl = this.#gl;
        const angle = limbAngle(camera);
        if (angle === null) {
            return;
        }
        const ring = [normalize(camera.position), ...circleAround(camera.position, angle, LIMB_POINTS)];
        const seen = ring.map(direction => subtract(scale(direction, REFERENCE_RADIUS), camera.position));
        const points = seen.flatMap(point => [camera.right, camera.up, camera.forward].map(axis => dot(axis, point)));
        gl.disable(gl.DEPTH_TEST);
        gl.uniformMatrix3fv(this.#at.turn, false, IDENTITY);
        gl.uniform3f(this.#at.eye, 0, 0, 0);
        gl.uniform1i(this.#at.isOpen, 1);
        gl.bindBuffer(gl.ARRAY_BUFFER, this.#buffers.limb);
        gl.bufferData(gl.ARRAY_BUFFER, new Float32Array(points), gl.STREAM_DRAW);
        gl.vertexAttribPointer(0, 3, gl.FLOAT, false, 12, 0);
        gl.disableVertexAttribArray(1);
        gl.drawArrays(gl.TRIANGLE_FAN, 0, ring.length);
    }
}
