// Figures that move: their code, the lessons' own compiled to WebAssembly, is in live-code.js beside the pages, which is loaded
// where a page has such a figure. What they are and do is written in book/live; here is what all of them share. Without scripts or
// WebAssembly, in print and on the page of all chapters the still figures stay. Nothing moves unless a reader moves it.
{
    /// A change should be seen within so many ms, before a screen shows its next picture.
    const FRAME = 16;

    const here = document.currentScript.src;
    const still = [...document.querySelectorAll("figure[data-live]")];
    const runs = typeof WebAssembly === "object" && typeof DecompressionStream === "function";
    if (still.length && runs && !location.pathname.endsWith("/print.html")) {
        // live-code.js calls it: a page that is opened as a file may load scripts, but fetch nothing.
        globalThis.liveFigures = begin;
        const script = document.createElement("script");
        script.src = new URL("../live-code.js", here).href;
        document.head.append(script);
    }

    /// Sets all figures of the page going.
    async function begin({ figures, style, code, head }) {
        const [program, model] = await Promise.all([code, head].map(unpack));
        const { instance } = await WebAssembly.instantiate(program, {});
        model.forEach((byte) => instance.exports.push(byte));
        instance.exports.give();
        document.head.append(element("style", { textContent: style }));
        for (const figure of still) {
            const n = figures.findIndex(({ name }) => name === figure.dataset.live);
            if (n >= 0) move(figure, figures[n], (values, coarse = false) => render(instance.exports, n, values, coarse));
        }
    }

    /// The bytes that live-code.js has compressed and in base64.
    async function unpack(text) {
        const packed = new Blob([Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0))]);
        const unpacked = new Response(packed.stream().pipeThrough(new DecompressionStream("deflate")));
        return new Uint8Array(await unpacked.arrayBuffer());
    }

    /// Draws a figure by the lessons' code, with fewer pixels if it is to be coarse. Returns its numbers and its parts, as
    /// `Rendered` in book/live lists them.
    function render({ memory, push, draw, start, length, number }, n, values, coarse) {
        values.forEach((value) => push(value));
        draw(n, coarse);
        const bytes = (part) => new Uint8ClampedArray(memory.buffer, start(part), length(part));
        const text = (part) => new TextDecoder().decode(bytes(part));
        const [width, height, x, y, scale] = [0, 1, 2, 3, 4].map((at) => number(at));
        return { width, height, x, y, scale, bytes, text };
    }

    /// Puts a figure that moves in the place of a still one.
    function move(figure, { name, stays, hint, inputs }, render) {
        const image = figure.querySelector("img");
        const drawing = element("div", { className: "live-drawing", role: "img", ariaLabel: image.alt });
        const picture = element("div", { className: "live-picture" }, drawing);
        const controls = element("div", { className: "live-controls" });
        const told = element("p", { className: "live-told" });
        const table = element("div", { className: "table-wrapper live-table" });
        // What is told changes with every step of a drag; who hears it is told where the drag ends.
        const heard = element("output", { className: "live-heard", ariaLive: "polite" });
        const panel = element("div", { className: "live", role: "group", ariaLabel: hint }, picture,
            element("p", { className: "live-hint", textContent: hint }), controls, told, table, heard);

        // The arrow keys turn the book's pages, too.
        panel.addEventListener("keydown", (event) => event.stopPropagation());

        const first = inputs.flatMap(({ from }) => from);
        let values = [...first];
        let view;
        let asked = false;
        let slow = false;
        let sharp;
        let quiet;
        const parts = [];
        const change = (at, ...numbers) => {
            values.splice(at, numbers.length, ...numbers);
            if (!asked) requestAnimationFrame(() => show(slow));
            asked = true;
        };
        const show = (coarse) => {
            asked = false;
            const begun = performance.now();
            view = render(values, coarse);
            paint(drawing, view);
            // What is counted in a coarse picture is not what is counted in the whole one.
            if (!coarse) {
                told.textContent = view.text(1);
                fill(table, view.text(2));
            }
            parts.forEach((part) => part(values, view));
            const { duration } = performance.measure("live", { start: begun, detail: name });
            // What takes longer than a frame of a screen is coarse as long as it changes, and drawn again when it rests.
            if (!coarse) slow = duration > FRAME;
            // The browser's test waits by it.
            panel.toggleAttribute("data-coarse", coarse);
            clearTimeout(sharp);
            if (coarse) sharp = setTimeout(show, 100, false);
            clearTimeout(quiet);
            quiet = setTimeout(() => { heard.textContent = told.textContent; }, 500);
        };
        let at = 0;
        for (const input of inputs) {
            const set = change.bind(null, at);
            const make = { point, slider, turn, choice, times }[input.kind];
            parts.push(make({ input, inputs, at, set, picture, controls, panel, render, values: () => values, view: () => view }));
            at += input.from.length;
        }
        const reset = element("button", { type: "button", textContent: "As at first" });
        reset.addEventListener("click", () => change(0, ...first));
        controls.append(reset);
        if (stays) {
            image.after(panel);
        } else {
            image.before(panel);
            figure.classList.add("live-on");
        }
        show(false);
        clearTimeout(quiet);
        // The first picture takes longer: what all have in common is made with it.
        slow = false;
    }

    /// A point of the drawing, as a handle on it.
    function point({ input, at, set, picture, values, view }) {
        const handle = element("button", { type: "button", className: "live-handle" });
        const go = (next) => set(...next.map((value, axis) => {
            const steps = Math.round((value - input.low[axis]) / input.step);
            const last = Math.round((input.high[axis] - input.low[axis]) / input.step);
            return input.low[axis] + Math.min(Math.max(steps, 0), last) * input.step;
        }));
        drag(handle, ({ clientX, clientY }) => {
            const { left, top, width } = picture.getBoundingClientRect();
            const { x, y, scale, width: units } = view();
            const [across, down] = [clientX - left, clientY - top].map((pixels) => pixels * units / width);
            go([(across - x) / scale, (y - down) / scale]);
        });
        handle.addEventListener("keydown", (event) => {
            const way = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowDown: [0, -1], ArrowUp: [0, 1] }[event.key];
            if (!way) return;
            event.preventDefault();
            const step = input.step * (event.shiftKey ? 5 : 1);
            go(way.map((along, axis) => values()[at + axis] + along * step));
        });
        picture.append(handle);
        return (values, { width, height, x, y, scale }) => {
            const place = values.slice(at, at + 2);
            handle.style.left = `${(x + place[0] * scale) / width * 100}%`;
            handle.style.top = `${(y - place[1] * scale) / height * 100}%`;
            handle.ariaLabel = `${input.label}, at ${place.map(short).join(", ")}; the arrow keys move it`;
        };
    }

    /// A slider with its label and its value.
    function slider({ input, at, set, controls }) {
        const range = element("input", { type: "range", min: input.low, max: input.high, step: input.step });
        const shown = element("span", { className: "live-value" });
        range.addEventListener("input", () => set(range.valueAsNumber));
        controls.append(element("label", {}, `${input.label} `, range, shown));
        return (values) => {
            range.value = values[at];
            shown.textContent = short(values[at]);
        };
    }

    /// What is turned by dragging over the picture, and by two sliders.
    function turn({ input, at, set, picture, controls, values, view }) {
        const sliders = ["To the right, in degrees", "Down, in degrees"].map((label, axis) => slider({
            controls,
            input: { label, low: input.low[axis], high: input.high[axis], step: 1 },
            at: at + axis,
            set: (value) => set(...values().slice(at, at + 2).with(axis, value)),
        }));
        picture.classList.add("live-turned");
        let from;
        drag(picture, ({ type, clientX, clientY }) => {
            if (type === "pointerdown") from = { right: values()[at], down: values()[at + 1], x: clientX, y: clientY };
            // Across the picture is half a turn.
            const degrees = 180 / picture.getBoundingClientRect().width;
            const right = Math.round(from.right + (clientX - from.x) * degrees);
            const down = Math.round(from.down + (clientY - from.y) * degrees);
            set(((right + 180) % 360 + 360) % 360 - 180, Math.min(Math.max(down, -90), 90));
        });
        // A finger that scrolls the page instead has turned it a little.
        picture.addEventListener("pointercancel", () => set(from.right, from.down));
        return (...shown) => sliders.forEach((part) => part(...shown));
    }

    /// A choice from a table of methods, with what the chosen one promises.
    function choice({ input, at, set, controls }) {
        const select = element("select", {}, ...input.rows.map(({ name }) => element("option", { textContent: name })));
        const says = element("p", { className: "live-promise" });
        select.addEventListener("change", () => set(select.selectedIndex));
        controls.append(element("label", {}, `${input.label} `, select), says);
        return (values) => {
            const { promise, failure } = input.rows[values[at]];
            select.selectedIndex = values[at];
            says.textContent = failure === "-" ? `${promise}.` : `${promise}. Fails: ${failure}.`;
        };
    }

    /// A button that draws by each method of the choice before it, and tells how long each takes.
    function times({ input, inputs, at, panel, render, values }) {
        const { rows } = inputs[inputs.indexOf(input) - 1];
        const words = "Time all methods";
        const button = element("button", { type: "button", textContent: words });
        const says = element("output", {});
        const table = element("div", { className: "table-wrapper live-table" });
        panel.append(element("div", { className: "live-times" }, button, says), table);
        // Of another picture they would be other times; which method is chosen does not matter.
        const picture = (values) => String(values.toSpliced(at - 1, 1));
        let timed;
        let running = false;
        const forget = () => {
            table.replaceChildren();
            says.textContent = "";
        };
        const run = (begins) => {
            running = begins;
            button.ariaDisabled = begins;
        };
        button.addEventListener("click", async () => {
            if (running) return;
            run(true);
            forget();
            const fixed = [...values()];
            timed = picture(fixed);
            const all = await race(rows.map((_, row) => () => render(fixed.with(at - 1, row))),
                (round, rounds) => { button.textContent = `${words}: ${round} of ${rounds}`; });
            button.textContent = words;
            run(false);
            if (picture(values()) !== timed) return;
            says.textContent = "In this browser, on one thread: medians of rounds in which all took turns.";
            const cells = rows.map(({ name }, row) => [name, all[row].toFixed(2), (all[0] / all[row]).toFixed(2)]);
            fill(table, [["Method", "ms a picture", `Times as fast as ${rows[0].name}`], ...cells]
                .map((row) => row.join("\t")).join("\n"));
        });
        return (values) => {
            if (picture(values) !== timed) forget();
        };
    }

    /// How long each of some functions takes, in ms: the median of rounds in which all take turns, each round beginning with another,
    /// and each as many times over as a browser's coarse clock needs. Between two rounds the page is drawn.
    async function race(runs, tell) {
        const ROUNDS = 11;
        const LEAST = 20;
        const samples = runs.map(() => []);
        for (let round = 1; round <= ROUNDS; round++) {
            tell(round, ROUNDS);
            await new Promise((done) => { requestAnimationFrame(() => setTimeout(done)); });
            for (let turn = 0; turn < runs.length; turn++) {
                const n = (turn + round) % runs.length;
                // The first picture by a method makes its memory ready, and is not timed.
                runs[n]();
                const begun = performance.now();
                let [count, taken] = [0, 0];
                while (taken < LEAST) {
                    runs[n]();
                    count += 1;
                    taken = performance.now() - begun;
                }
                samples[n].push(taken / count);
            }
        }
        return samples.map((all) => all.sort((a, b) => a - b)[(ROUNDS - 1) / 2]);
    }

    /// Calls `moved` while a part is dragged, by mouse, pen or finger.
    function drag(part, moved) {
        part.addEventListener("pointerdown", (event) => {
            if (event.button !== 0) return;
            part.setPointerCapture(event.pointerId);
            moved(event);
        });
        part.addEventListener("pointermove", (event) => part.hasPointerCapture(event.pointerId) && moved(event));
    }

    /// Shows a drawing, lines and letters as SVG, pixels on a canvas.
    function paint(drawing, { width, height, scale, bytes, text }) {
        if (scale) {
            drawing.innerHTML = text(0);
            return;
        }
        let canvas = drawing.querySelector("canvas");
        if (!canvas) drawing.append(canvas = element("canvas", {}));
        if (canvas.width !== width || canvas.height !== height) Object.assign(canvas, { width, height });
        canvas.getContext("2d").putImageData(new ImageData(bytes(0), width, height), 0, 0);
    }

    /// Shows a table, whose first row and first column name the others.
    function fill(wrapper, text) {
        if (!text) return;
        const rows = text.split("\n").map((row) => row.split("\t"));
        const cell = (words, row, column) => element(row && column ? "td" : "th",
            { textContent: words, scope: row ? "row" : "col" });
        wrapper.replaceChildren(element("table", {}, ...rows.map((words, row) =>
            element("tr", {}, ...words.map((word, column) => cell(word, row, column))))));
        if (wrapper.scrollWidth > wrapper.clientWidth) wrapper.tabIndex = 0;
        else wrapper.removeAttribute("tabindex");
    }

    /// A number with as many digits as it needs, at most three behind the point.
    function short(number) {
        return String(Number(number.toFixed(3))).replace("-", "−");
    }

    /// An element with its properties and its content.
    function element(name, properties, ...content) {
        const made = Object.assign(document.createElement(name), properties);
        made.append(...content);
        return made;
    }
}
