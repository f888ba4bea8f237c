// Charts that answer: what a reader points at is told, with the command that draws by it; methods can be switched off; where
// all methods were measured at the same sizes, a slider picks one. A chart comes in a script beside its file, charts/NAME.js, which
// is loaded where a page shows the chart: a page that is opened as a file may load scripts, but fetch nothing. Its marks say what
// is told of them. Without scripts, in print and on the page of all chapters the still charts stay.
{
    const HINT = "Point at a mark, or go there by Tab and the arrow keys, to be told its values.";
    /// As in the pages' <picture>.
    const small = matchMedia("(max-width: 560px)");
    /// How far from a mark, in CSS pixels, it can be pointed at.
    const NEAR = 26;
    const ALIKE = 3;

    const figures = location.pathname.endsWith("/print.html") ? [] : [...document.querySelectorAll("figure.chart")];
    globalThis.liveChart = (chart) => {
        const figure = figures.find(({ id }) => id === `fig-${chart.name}`);
        // A chart that was drawn before marks told anything stays still.
        if (chart.wide.includes("data-of")) begin(figure, chart);
    };
    for (const figure of figures) {
        const src = figure.querySelector("a").href.replace(/\.svg$/, ".js");
        document.head.append(element("script", { src }));
    }

    /// Puts a chart that answers in the place of a still one.
    function begin(figure, { wide, narrow, commands }) {
        const link = figure.querySelector("a");
        const drawing = element("div", { className: "chart-drawing" });
        const told = element("p", { className: "chart-told", textContent: HINT });
        const switches = element("div", { className: "chart-switches", role: "group", ariaLabel: "Shown in the chart" });
        const panel = element("div", { className: "chart-live" }, drawing, told, switches);
        const file = element("a", { className: "chart-file", href: link.href, textContent: "Chart as a file" });
        /// Selectors of what is switched off.
        const off = new Set();
        let svg, points, ring;

        const draw = () => {
            drawing.innerHTML = small.matches ? narrow : wide;
            svg = drawing.querySelector("svg");
            svg.querySelector("title").remove();
            svg.role = "group";
            svg.ariaLabel = link.querySelector("img").alt;
            points = [...svg.querySelectorAll(".point")];
            points.forEach(prepare);
            ring = document.createElementNS(svg.namespaceURI, "circle");
            for (const [name, value] of Object.entries({ class: "chart-ring", r: 10, visibility: "hidden" })) ring.setAttribute(name, value);
            svg.append(ring);
            svg.addEventListener("keydown", walk);
            svg.addEventListener("focusin", ({ target }) => points.includes(target) && show([target]));
            ["pointermove", "pointerdown"].forEach((kind) => svg.addEventListener(kind, pointed));
            // Else the mark on top is focused and told, though another one is nearer.
            svg.addEventListener("mousedown", (event) => event.preventDefault());
        };
        /// The words of a mark, which a browser would show as a tip, become its name.
        const prepare = (point) => {
            const title = point.querySelector("title");
            title.remove();
            point.role = "img";
            const command = commandOf(point);
            point.ariaLabel = title.textContent.trim() + (command ? `. Drawn by ${command}` : "");
            point.dataset.told = title.textContent.trim();
        };
        const methodOf = (point) => point.closest("[data-of]").dataset.of;
        // Where methods share a line, it has the names of all.
        const commandOf = (point) => methodOf(point).split(", ").map((method) => commands[method]).find(Boolean);
        const seen = () => points.filter((point) => !point.closest(".off"));

        /// Tells of marks, of the first one all.
        const show = ([point, ...others]) => {
            const { x, y, width, height } = point.getBBox();
            ring.setAttribute("cx", x + width / 2);
            ring.setAttribute("cy", y + height / 2);
            ring.setAttribute("visibility", "visible");
            told.replaceChildren(`${point.dataset.told}.`);
            if (others.length) told.append(` In the same place: ${others.map(methodOf).join(", ")}.`);
            const command = commandOf(point);
            if (command) told.append(" ", element("code", { textContent: command }));
            points.forEach((other) => { other.setAttribute("tabindex", other === point ? 0 : -1); });
        };
        /// By mouse, pen or finger.
        const pointed = ({ clientX, clientY }) => {
            const far = (point) => {
                const { left, right, top, bottom } = point.getBoundingClientRect();
                return Math.hypot(clientX - (left + right) / 2, clientY - (top + bottom) / 2);
            };
            // Of those in the same place the last one is on top.
            const near = seen().reverse().map((point) => ({ point, distance: far(point) })).sort((a, b) => a.distance - b.distance);
            if (!near.length || near[0].distance > NEAR) return;
            const least = near[0].distance;
            show(near.filter(({ distance }) => distance < least + ALIKE).map(({ point }) => point));
        };
        /// By keys: to the left and right from mark to mark, up and down to the next method.
        const walk = (event) => {
            const step = { ArrowLeft: -1, ArrowUp: -1, ArrowRight: 1, ArrowDown: 1 }[event.key];
            if (!step) return;
            event.preventDefault();
            const shown = seen();
            const n = shown.indexOf(event.target);
            const rest = step > 0 ? shown.slice(n + 1) : shown.slice(0, n).reverse();
            const { at, kind } = event.target.dataset;
            const other = (point) => methodOf(point) !== methodOf(event.target);
            const beside = (point) => other(point) && point.dataset.at === at && point.dataset.kind === kind;
            const next = /Left|Right/.test(event.key) ? rest[0] : rest.find(beside) ?? rest.find(other);
            next?.focus();
        };

        const apply = () => {
            for (const part of svg.querySelectorAll("[data-of], [data-kind]")) {
                part.classList.toggle("off", [...off].some((selector) => part.matches(selector)));
            }
            ring.setAttribute("visibility", "hidden");
            told.textContent = HINT;
            const [first] = seen();
            points.forEach((point) => { point.setAttribute("tabindex", point === first ? 0 : -1); });
        };
        /// A button that switches off what a selector names, and on again.
        const addSwitch = (name, selector, ...swatch) => {
            const button = element("button", { type: "button", ariaPressed: "true" }, ...swatch, name);
            button.addEventListener("click", () => {
                const on = off.delete(selector);
                if (!on) off.add(selector);
                button.ariaPressed = String(on);
                apply();
                slide();
            });
            switches.append(button);
        };
        /// A slider for the sizes at which all lines have a point, and what they are there.
        const addSlider = (methods) => {
            const sizes = [...new Set(points.map(({ dataset }) => dataset.at))];
            const across = svg.dataset.across;
            // Where each method has sizes of its own there is nothing to compare.
            if (!across || points.length <= sizes.length * methods.length / 2) return () => {};
            const range = element("input", { type: "range", min: 0, max: sizes.length - 1, value: 0 });
            const size = element("strong");
            const values = element("output", { className: "chart-values", ariaLive: "polite" });
            const label = element("label", {}, `${across}: `, size, range);
            panel.append(element("div", { className: "chart-sizes" }, label, values));
            const slide = () => {
                const at = sizes[range.value];
                range.setAttribute("aria-valuetext", at);
                size.textContent = at;
                points.forEach((point) => point.classList.toggle("chosen", point.dataset.at === at));
                values.replaceChildren(...seen().filter((point) => point.dataset.at === at).map((point) =>
                    element("span", {}, `${methodOf(point)} `, element("strong", { textContent: point.dataset.value }))));
            };
            range.addEventListener("input", slide);
            return slide;
        };

        draw();
        const methods = [...new Set(points.map(methodOf))];
        for (const method of methods) {
            const selector = `[data-of="${CSS.escape(method)}"]`;
            addSwitch(method, selector, swatch(svg.querySelector(`${selector} .point`)));
        }
        for (const [kind, sign] of [["worst case", "●"], ["mean", "○"]]) {
            if (svg.querySelector(`[data-kind="${kind}"]`)) addSwitch(`${sign} ${kind}`, `[data-kind="${kind}"]`);
        }
        const slide = addSlider(methods);
        panel.append(file);
        const all = () => { apply(); slide(); };
        all();
        small.addEventListener("change", () => { draw(); all(); });
        // The arrow keys turn the book's pages, too.
        panel.addEventListener("keydown", (event) => event.stopPropagation());
        link.before(panel);
        figure.classList.add("chart-on");
    }

    /// A method's colour.
    function swatch(point) {
        const hue = point.outerHTML.match(/class="[fs](\d)"/);
        const holder = element("span", { ariaHidden: "true" });
        holder.innerHTML = `<svg width="11" height="11"><circle class="${hue ? `f${hue[1]}` : "soft"}" cx="5.5" cy="5.5" r="5.5"/></svg>`;
        return holder;
    }

    /// An element with its properties and its content.
    function element(name, properties, ...content) {
        const made = Object.assign(document.createElement(name), properties);
        made.append(...content);
        return made;
    }
}
